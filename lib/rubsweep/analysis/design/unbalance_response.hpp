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

/// Range of shaft speeds, 0 < from_hz < to_hz.
struct SpeedRange {
  double from_hz = 0, to_hz = 0;

  bool contains(double speed_hz) const { return speed_hz >= from_hz && speed_hz <= to_hz; }
};

/// Largest value of a quantity over the speed, and the speed at which it occurs.
struct Largest {
  double speed_hz = 0;
  double value = 0;
};

/// Speeds at which a response is sampled, ascending. They are evenly spaced over the range, and denser around
/// critical speeds, in proportion to the width of these resonances.
std::vector<double> response_speeds(const SpeedRange& range, std::span<const linear::CriticalSpeed> critical);

/// Speeds of an ascending list that lie in a range, and both ends of the range.
std::vector<double> within(const SpeedRange& range, std::span<const double> speeds_hz);

/// Largest `value` over the range of `speeds_hz`, which ascend. Samples are taken at these speeds. Around
/// each sample that is larger than both neighbours, the maximum is refined (Brent). A value that is not
/// finite counts as infinite.
Largest largest_over_speed(std::span<const double> speeds_hz, const std::function<double(double)>& value);

/// Full major axis of the ellipse x = Re(X e^{i w t}), y = Re(Y e^{i w t}), in the unit of `amplitude` = (X,
/// Y). The forward circle has the radius |X + i Y| / 2, the backward circle |X - i Y| / 2; the sum of both
/// radii is half the axis. The axis is at least the peak to peak value of x and of y, and larger for an
/// inclined ellipse.
double major_axis(const Eigen::Vector2cd& amplitude);

/// Place on the shaft whose motion is evaluated.
struct WatchedPlace {
  std::optional<double> position_m;  ///< place along the shaft; empty for a Jeffcott rotor
  contact::RelativeMap map;          ///< 2 x n: displacement in x and y = map * q, in metres
  std::string name = {};             ///< names of the sensors there; may be empty
};

/// Places of the probes, one for each position that has sensors; the rotor itself where there are no sensors.
std::vector<WatchedPlace> probe_places(const scene::PreparedMachine& prepared);

/// Places of the stops in their order; the motion is relative to the casing.
std::vector<WatchedPlace> stop_places(const scene::PreparedMachine& prepared);

/// Quiet motion of a machine at a speed > 0 with an eccentricity of 1 m, without bow and misalignment of
/// couplings. Where supports depend on the speed, the motion is in the coordinates that hold at all speeds.
/// The tables must reach the speed.
scene::QuietMotion unit_response(const scene::PreparedMachine& prepared, double speed_hz);

}  // namespace rubsweep::design
