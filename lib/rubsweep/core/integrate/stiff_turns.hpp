#pragma once

#include <span>

#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/integrate/run/turn_book.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::integrate {

/// Slow turns beside a stiff contact whose vibration has died out. Taylor pieces are no longer than a few
/// radians of that vibration, there or not, and a turn may hold fifty thousand of them. Where no contact
/// changes its mode an implicit stepper follows the slow motion alone, by a hundred steps.
class StiffTurns {
 public:
  /// `scene` must outlive this.
  StiffTurns(const scene::Scene& scene, const run::SolverOptions& options);

  /// Takes note of a turn that pieces have made: so many, and `changes` of mode.
  void look(long pieces, long changes);
  /// Whether the next turn is to be tried. Moves no tangent vectors.
  bool due() const { return due_; }
  /// Makes turn number `revolution` from `section`. False where it takes so many steps that pieces are as
  /// good: the report is of no use then, and tries become rarer.
  bool advance(std::span<const double> section, long revolution, const run::TurnRequest& request,
               run::TurnReport& report);
  /// Forgets all but the work.
  void restart();

  /// Work of all of these turns.
  run::Effort effort() const { return past_ + present_; }

 private:
  void end();

  const scene::Scene& scene_;
  run::SolverOptions options_;
  run::Cursor stepper_;  ///< empty while other solvers make the turns
  bool due_ = false;
  int wait_ = 0, waited_ = 0;  ///< turns that would be tried, before the next try
  int stretch_ = 0;            ///< turns that were made without a break
  run::Effort past_, present_;
};

}  // namespace rubsweep::integrate
