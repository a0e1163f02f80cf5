#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>

#include "rubsweep/analysis/branch/orbits/orbit_problem.hpp"
#include "rubsweep/core/contact/contact_mode.hpp"

namespace rubsweep::branch::orbits {

/// A place in the plane of two parameters, and the shaft angle at which the turns of an orbit begin.
struct PlanePoint {
  double first = 0, second = 0;
  double phase_rad = 0;
  /// Contact that the orbits are clear of: its force is left out, so that they are smooth where they come to
  /// touch everywhere at once. Below 0: none.
  int clear_of = -1;

  bool operator==(const PlanePoint&) const = default;
};

/// The guard of one contact from one of its modes to another.
struct ArmedGuard {
  int contact = 0;
  contact::Mode from = contact::Mode::open, to = contact::Mode::open;
};

/// A guard at one state, as a scaled length, with its first two derivatives by the shaft angle.
struct GuardMotion {
  double value = 0, rate = 0, curvature = 0;
};

struct ParameterRange {
  double low = 0, high = 0;

  double width() const { return high - low; }
  bool holds(double value) const { return value >= low && value <= high; }
};

/// Orbits of a map with two parameters: as OrbitProblem, whose members mean the same here.
struct PlaneOrbits {
  std::function<Evaluation(const PlanePoint&, Eigen::VectorXd& state, Eigen::MatrixXd* monodromy)> returns;
  /// May be left out.
  std::function<std::optional<OrbitFacts>(const PlanePoint&, const Eigen::VectorXd& state)> facts;
  /// The guard at the start of a turn; empty where it cannot be told. May be left out where no graze is
  /// followed, as may `at_phase`.
  std::function<std::optional<GuardMotion>(const PlanePoint&, const Eigen::VectorXd& state,
                                           const ArmedGuard&)>
      guard;
  /// The state `phase_rad` >= 0 after the start of the orbit, at the sample next to it: the phase becomes
  /// that of the sample.
  std::function<std::optional<Eigen::VectorXd>(const PlanePoint&, const Eigen::VectorXd& state,
                                               double& phase_rad)>
      at_phase;
  int order = 1;
  ParameterRange first, second;
};

}  // namespace rubsweep::branch::orbits
