#pragma once

#include <optional>
#include <string>

#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::sweep {

/// One line that says why no cell below a whirl ratio of 1 will ever touch a wall: there is no kick, or none
/// that gets that far. Empty where some cell may touch, as far as a bound can tell: the kick counts with its
/// whole impulse at once and the free vibration by the sizes of its modes, so that a kick much longer than
/// the rotor's period may be too weak without being named. Looks at every speed of a small grid and at speeds
/// all over a large one, and at the largest unbalance that leaves a clearance there. Empty too where the grid
/// has axes over keys.
std::string why_walls_stay_untouched(const Study& study, const scene::PreparedMachine& prepared);

/// Where a weak kick is why, force in newtons from which on that bound lets some cell touch, within 1 %: a
/// kick below it touches nothing, one above may. Empty where there is another reason or none, where the kick
/// has no force, and where no force up to 1e9 times its own is enough.
std::optional<double> least_kick_force_n(const Study& study, const scene::PreparedMachine& prepared);

/// Why the torsion of a rotor kit hardly changes the motion, one line for people; empty where the rotor has
/// none or where it may. Twist acts through the slip, and friction that is saturated does not ask how large
/// that is; and it turns the unbalance. The estimate: a hit of twice the kick's impulse changes the surface
/// speed by mu 2 I R^2 / J, which must leave the slip of the slowest shaft where every friction is saturated,
/// and which changes speed and direction of the unbalance by a hundredth at most.
std::string why_torsion_is_idle(const scene::PreparedMachine& prepared, double slowest_hz);

/// Word in the status of a row whose rotor is unstable without its stops
/// (response::proof::RestProof::vibration_grows).
inline constexpr const char* unstable_rotor = "unstable_rotor";

/// Where the premise of a quiet motion fails, one line for people: at which speeds of the study a free
/// vibration of the rotor without its stops grows (structure::grows), as by cross-coupled bearings or damping
/// that turns with the shaft. Empty where none does. At most 400 speeds are looked at, and 16 of the machines
/// that axes over keys make, spread evenly. `prepared` is that of study.machine.
/// Throws ConfigError where the full matrices of a kit say otherwise at the first, a middle and the last
/// speed, or where the growth is fastest.
std::string where_rotor_is_unstable(const Study& study, const scene::PreparedMachine& prepared);

}  // namespace rubsweep::sweep
