#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "rubsweep/analysis/linear/whirl_modes.hpp"

namespace rubsweep::linear {

/// Whirl mode at one shaft speed.
struct CampbellPoint {
  double speed_hz = 0;
  double frequency_hz = 0;   ///< damped natural frequency
  double damping_ratio = 0;  ///< share of critical damping; negative: unstable
  double forward_share = 0;  ///< see WhirlMode
};

/// One curve of a Campbell diagram: a mode that was followed over the speed by its shape.
struct CampbellMode {
  /// Number from 1, by the frequency at the first speed, backward before forward. Modes that are overdamped
  /// at the first speed follow in the order in which they begin to oscillate.
  int number = 0;
  std::vector<CampbellPoint> points;  ///< speeds at which the mode is not overdamped; may be empty
};

/// Critical speed, at which a whirl frequency equals the shaft speed, so that the unbalance is in resonance.
struct CriticalSpeed {
  int mode = 0;
  double speed_hz = 0;
  double damping_ratio = 0;
  double forward_share = 0;
};

/// Mode shape of the shaft: deflections Re(x e^{i w t}), Re(y e^{i w t}) at the places of the rotor. The
/// largest deflection is 1. The largest x is real and positive, or the largest y where x does not move.
struct ModeShape {
  int mode = 0;
  double speed_hz = 0;  ///< first critical speed, or the first speed at which the mode is found
  double frequency_hz = 0;
  double forward_share = 0;
  Eigen::VectorXcd x, y;
};

/// Largest growth rate of a free vibration at a speed, with or without whirl; 0 where none grows.
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

/// Campbell diagram of a rotor over `speeds_hz`, at least one, ascending and >= 0, from the full matrices. It
/// contains the modes whose frequency is below `up_to_hz` at some speed, the modes that grow at some speed,
/// and always the two slowest modes. Modes are followed from speed to speed by the modal assurance criterion.
/// Intermediate speeds are added where the criterion is not decisive and where modes begin or end. Critical
/// speeds are located to rounding. Throws SolverError as WhirlProblem does.
Campbell campbell(const FreeRotor& rotor, std::span<const double> speeds_hz, double up_to_hz);

/// Mode at one speed, with the data needed to follow it.
struct FollowedMode {
  double speed_hz = 0;
  WhirlMode mode;
};

/// Points at which the whirl frequency of a followed mode equals the shaft speed. They are located to
/// rounding between the points of `curve`, which ascend by speed. Throws SolverError where the mode is lost
/// between two points.
std::vector<FollowedMode> critical_points(const WhirlProblem& problem, std::span<const FollowedMode> curve);

}  // namespace rubsweep::linear
