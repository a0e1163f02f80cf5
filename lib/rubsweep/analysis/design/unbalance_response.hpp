#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "rubsweep/core/contact/wall.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/core/scene/quiet_motion.hpp"
#include "rubsweep/core/structure/linear_system.hpp"

namespace rubsweep::design {

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
