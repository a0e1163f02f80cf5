#pragma once

#include <span>

#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/integrate/run/turn_book.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::integrate {

/// Slow turns with a stiff contact whose vibration has decayed. Taylor pieces last no longer than a few
/// radians of this vibration, even if it is zero, so that a turn may need fifty thousand of them. Where
/// contacts rarely change their mode, an implicit stepper follows only the slow motion in some hundred steps.
class StiffTurns {
 public:
  /// `scene` must outlive this object.
  StiffTurns(const scene::Scene& scene, const run::SolverOptions& options);

  /// Notes a turn made of `pieces` Taylor pieces with `changes` of contact mode.
  void look(long pieces, long changes);
  /// Whether the next turn should be tried with the implicit stepper, which moves no tangent vectors.
  bool due() const { return due_; }
  /// Makes turn number `revolution` from `section`. False where it takes so many steps that Taylor pieces
  /// would cost no more. The report is then invalid, and later attempts become rarer.
  bool advance(std::span<const double> section, long revolution, const run::TurnRequest& request,
               run::TurnReport& report);
  void restart();  ///< Resets everything except the counted work.

  /// Work of all turns made here.
  run::Effort effort() const { return past_ + present_; }

 private:
  void end();

  const scene::Scene& scene_;
  run::SolverOptions options_;
  run::Cursor stepper_;  ///< empty while other solvers make the turns
  bool due_ = false;
  long most_changes_ = 0;      ///< changes of contact mode in a turn that is still stiff
  int wait_ = 0, waited_ = 0;  ///< turns to wait and turns waited before the next attempt
  int stretch_ = 0;            ///< successive turns made here
  run::Effort past_, present_;
};

}  // namespace rubsweep::integrate
