#pragma once

#include <Eigen/Core>
#include <functional>
#include <span>
#include <vector>

#include "rubsweep/core/integrate/run/work_bound.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::response::proof {

/// One iteration of a map, in place. False: it could not be computed, and the state is undefined.
using SectionMap = std::function<bool(std::span<double> state)>;

/// One revolution of a scene as a map of its scaled section (as TurnReport::section): from phase 0 to phase
/// 0, without the pulses. Every call starts afresh, so that the map has no memory: equal sections give equal
/// sections to the last bit, and nearby sections pass through nearly the same steps. Where the damping of a
/// contact depends on its approach speed, the map fails for a section in contact, because the section does
/// not determine the next turn.
class SceneMap {
 public:
  /// If there is a `budget`, the revolutions are charged to it, and they fail once it is used up. It must
  /// outlive the map.
  SceneMap(const scene::Scene& scene, const integrate::run::SolverOptions& solver,
           integrate::exact::modes::ModeCache& modes, integrate::run::WorkBudget* budget = nullptr);

  /// Replaces `section`, 2n numbers, by the section one revolution later. False when the solver fails.
  bool operator()(std::span<double> section);
  /// The same, but where `section` ends the latest revolution the exact solver continues. Rounding errors
  /// then differ from those of a fresh start, and after a turn without closed forms so may the method.
  bool go_on(std::span<double> section);

  /// The same, and every column of `disturbances` (2n rows, at most 2n columns) becomes its image under the
  /// derivative of the new section by the old. The derivative comes from the exact solver where the turn has
  /// closed forms. For Taylor pieces and for curved laws it has the accuracy `accuracy`; otherwise it comes
  /// from central differences.
  bool carry(std::span<double> section, Eigen::MatrixXd& disturbances,
             double accuracy = integrate::run::TurnRequest{}.tangent_accuracy);

  /// Moves `section` as `carry`, and `disturbances` only where the solver of the turn can move tangent
  /// vectors. `moved` tells whether it could; otherwise `disturbances` stays unchanged.
  bool carry_exactly(std::span<double> section, Eigen::MatrixXd& disturbances, bool& moved,
                     double accuracy = integrate::run::TurnRequest{}.tangent_accuracy);

  /// From now on, a turn that begins where the turn before ended continues it. Contacts whose damping depends
  /// on their approach speed then continue, so that sections may be in contact.
  void keep_memory() { keeps_memory_ = remembers_; }
  /// Whether a section in contact does not determine the next turn.
  bool remembers() const { return remembers_; }
  /// Whether some contact was touching at the end of the last revolution.
  bool touching_at_end() const { return report_.touching_at_end; }

  /// Whether the exact solver makes the turns, as far as they have closed forms.
  bool exact() const { return exact_; }

  /// Whether all revolutions so far had closed forms.
  bool closed_forms() const {
    return exact_ && report_.effort.taylor_turns == 0 && report_.effort.adaptive_turns == 0;
  }

  /// Whether there was contact at any time in the latest revolution.
  bool touched() const { return report_.touched; }

 private:
  bool advance(std::span<double> section, bool continues = false);
  void spend(bool counts_on);  ///< `counts_on`: the solver continues its count of work from before the turn.

  std::size_t states_;
  bool exact_;
  bool counts_on_;  ///< the work of a run goes on after a restart
  integrate::run::Run run_;
  integrate::run::WorkBudget* budget_;
  double work_ = 0;  ///< work of the run so far
  integrate::run::TurnRequest request_;
  integrate::run::TurnReport report_;
  std::vector<double> before_;
  bool moves_tangents_, remembers_, keeps_memory_ = false;
  bool whole_ = false;  ///< whether the latest revolution was completed
};

scene::Scene after_the_kick(scene::Scene scene);  ///< The scene without its pulses.

}  // namespace rubsweep::response::proof
