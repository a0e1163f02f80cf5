#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "rubsweep/analysis/linear/whirl_modes.hpp"

namespace rubsweep::linear {

/// A whirl mode at one shaft speed.
struct CampbellPoint {
  double speed_hz = 0;
  double frequency_hz = 0;   ///< frequency of the damped whirl
  double damping_ratio = 0;  ///< share of critical damping; negative: unstable
  double forward_share = 0;  ///< see WhirlMode
};

/// One curve of a Campbell diagram: a mode followed over the speed by its shape.
struct CampbellMode {
  /// From 1, by the frequency at the first speed, backward before forward; then those that are overdamped
  /// there, as they begin to oscillate.
  int number = 0;
  std::vector<CampbellPoint> points;  ///< speeds at which the mode is not overdamped; perhaps none
};

/// Critical speed: a whirl frequency equals the shaft speed, so that the unbalance is in resonance.
struct CriticalSpeed {
  int mode = 0;
  double speed_hz = 0;
  double damping_ratio = 0;
  double forward_share = 0;
};

/// How a mode bends the shaft: deflections Re(x e^{i w t}), Re(y e^{i w t}) over the places of the rotor. The
/// largest is 1; x is real and positive where it is largest, or y where x does not move.
struct ModeShape {
  int mode = 0;
  double speed_hz = 0;  ///< first critical speed, or the first speed at which the mode is found
  double frequency_hz = 0;
  double forward_share = 0;
  Eigen::VectorXcd x, y;
};

/// Growth of the free vibration that grows fastest at a speed, whirl or not; 0 where none does.
struct GrowthAt {
  double speed_hz = 0, growth_per_s = 0;
};

struct Campbell {
  std::vector<double> position_m;
  std::vector<CampbellMode> modes;
  std::vector<CriticalSpeed> critical_speeds;  ///< ascending
  std::vector<ModeShape> shapes;               ///< shape of each mode
  std::vector<GrowthAt> growth;                ///< growth at each speed
};

/// Campbell diagram of a rotor over `speeds_hz`, ascending and >= 0, at least one: the modes whose frequency
/// comes below `up_to_hz` somewhere, those that grow somewhere, and the two slowest in any case, from the
/// full matrices. Modes are followed from speed to speed by the modal assurance criterion, with more speeds
/// in between where it is in doubt or where modes begin or end. Critical speeds are located to rounding.
/// Throws SolverError as WhirlProblem.
Campbell campbell(const FreeRotor& rotor, std::span<const double> speeds_hz, double up_to_hz);

/// A mode at one speed, as it is needed to follow it.
struct FollowedMode {
  double speed_hz = 0;
  WhirlMode mode;
};

/// Points at which the whirl frequency of a followed mode equals the shaft speed, located to rounding between
/// its points, which ascend by speed. Throws SolverError where the mode is lost between two of them.
std::vector<FollowedMode> critical_points(const WhirlProblem& problem, std::span<const FollowedMode> curve);

}  // namespace rubsweep::linear
