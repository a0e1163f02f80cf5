#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "rubsweep/analysis/linear/campbell.hpp"
#include "rubsweep/core/contact/wall.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/core/scene/quiet_motion.hpp"
#include "rubsweep/core/structure/linear_system.hpp"

namespace rubsweep::design {

/// Speeds of a shaft, 0 < from_hz < to_hz.
struct SpeedRange {
  double from_hz = 0, to_hz = 0;

  bool contains(double speed_hz) const { return speed_hz >= from_hz && speed_hz <= to_hz; }
};

/// Where a quantity is largest over the speed.
struct Largest {
  double speed_hz = 0;
  double value = 0;
};

/// Speeds of a range at which a response is sampled, ascending: evenly spaced, and closer about critical
/// speeds, by the width of their resonances.
std::vector<double> response_speeds(const SpeedRange& range, std::span<const linear::CriticalSpeed> critical);

/// The largest `value` from the first to the last of `speeds_hz`, ascending: of the samples, and of what lies
/// between the two neighbours of each sample that is larger than both (Brent). A value that is not finite
/// counts as infinite.
Largest largest_over_speed(std::span<const double> speeds_hz, const std::function<double(double)>& value);

/// Major axis of the ellipse x = Re(X e^{i w t}), y = Re(Y e^{i w t}), from end to end, in the unit of
/// `amplitude` = (X, Y). The forward circle has the radius |X + i Y| / 2, the backward one |X - i Y| / 2, and
/// their sum is half the axis: never less than the peak to peak of x or of y, and more where the ellipse
/// leans.
double major_axis(const Eigen::Vector2cd& amplitude);

/// A place at which the motion of the shaft is looked at.
struct WatchedPlace {
  std::optional<double> position_m;  ///< along the shaft; empty: of a Jeffcott rotor
  contact::RelativeMap map;          ///< 2 x n: displacement in x and y = map * q, in metres
};

/// Places of the probes, one for each place along the shaft that has sensors; the rotor itself where there
/// are none.
std::vector<WatchedPlace> probe_places(const scene::PreparedMachine& prepared);

/// Places of the stops in their order, the motion against the casing.
std::vector<WatchedPlace> stop_places(const scene::PreparedMachine& prepared);

/// The quiet motion of a machine that turns at a speed > 0 with an eccentricity of 1 m, without its bow and
/// its couplings out of line. Where supports follow the speed, in the coordinates that serve all speeds. The
/// tables must reach the speed.
scene::QuietMotion unit_response(const scene::PreparedMachine& prepared, double speed_hz);

/// Major axis of the ellipse that a place goes through, from end to end, in the unit of the motion. Not
/// finite at an undamped resonance.
double major_axis_at(const scene::QuietMotion& motion, const WatchedPlace& place);

}  // namespace rubsweep::design
