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

/// One revolution of a scene as a map of its scaled section (as TurnReport::section), from phase 0 to phase
/// 0, without the pulses. Every call starts anew, so that the map has no memory: equal sections give bitwise
/// equal sections, and neighbouring sections take nearly the same steps.
class SceneMap {
 public:
  /// If there is a `budget`, it pays for the revolutions, which fail once it is used up. It must outlive the
  /// map.
  SceneMap(const scene::Scene& scene, const integrate::run::SolverOptions& solver,
           integrate::exact::modes::ModeCache& modes, integrate::run::WorkBudget* budget = nullptr);

  /// Replaces `section`, 2n numbers, by the section one revolution later. False when the solver fails.
  bool operator()(std::span<double> section);

  /// Moves `section` by one revolution, and multiplies each column of `disturbances` (2n rows, at most 2n
  /// columns) by the derivative of the new section by the old one. The derivative is exact where the turn has
  /// closed forms, accurate to `accuracy` by Taylor pieces, or else by central differences.
  bool carry(std::span<double> section, Eigen::MatrixXd& disturbances,
             double accuracy = integrate::run::TurnRequest{}.tangent_accuracy);

  /// Moves `section` as `carry`, and `disturbances` only where the solver of the turn can move tangent
  /// vectors. `moved` tells whether it could; otherwise `disturbances` stays unchanged.
  bool carry_exactly(std::span<double> section, Eigen::MatrixXd& disturbances, bool& moved,
                     double accuracy = integrate::run::TurnRequest{}.tangent_accuracy);

  /// Whether the exact solver makes the turns that have closed forms.
  bool exact() const { return exact_; }

  /// Whether all revolutions so far had closed forms.
  bool closed_forms() const {
    return exact_ && report_.effort.taylor_turns == 0 && report_.effort.adaptive_turns == 0;
  }

  /// Whether there was contact at any time in the latest revolution.
  bool touched() const { return report_.touched; }

 private:
  bool advance(std::span<double> section);
  void spend();

  std::size_t states_;
  bool exact_;
  integrate::run::Run run_;
  integrate::run::WorkBudget* budget_;
  double work_ = 0;  ///< work of the run so far
  integrate::run::TurnRequest request_;
  integrate::run::TurnReport report_;
  std::vector<double> before_;
};

/// The scene without its pulses.
scene::Scene after_the_kick(scene::Scene scene);

}  // namespace rubsweep::response::proof
