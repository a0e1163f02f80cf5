#pragma once

#include <optional>
#include <string>

#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::sweep {

/// One line with the reason why no cell below a whirl ratio of 1 will ever touch a wall: there is no kick, or
/// it is too weak. Empty where a bound cannot exclude contact. The bound assumes that the whole impulse acts
/// in an instant, and adds the amplitudes of the free modes. So it may not report a weak kick that is much
/// longer than the rotor's period. Checks every speed of a small grid, or some speeds spread over a large
/// one, each at the largest unbalance that leaves a clearance. Empty also where the grid has axes over keys.
std::string why_walls_stay_untouched(const Study& study, const scene::PreparedMachine& prepared);

/// Force in newtons, within 1 %, above which the bound of why_walls_stay_untouched no longer excludes
/// contact. A weaker kick touches nothing, a stronger one may touch. Empty unless a weak kick is the reason,
/// and where the kick has no force or 1e9 times its force is still too weak.
std::optional<double> least_kick_force_n(const Study& study, const scene::PreparedMachine& prepared);

/// One line with the reason why the torsion of a rotor kit hardly changes the motion; empty without torsion,
/// or where it may matter. Twist acts in two ways: it changes the slip, on which saturated friction does not
/// depend, and it turns the unbalance. The estimate: an impact of twice the kick's impulse I changes the
/// surface speed by mu 2 I R^2 / J. The slip of the slowest shaft must then still be large enough to saturate
/// every friction, and speed and direction of the unbalance may change by at most a hundredth.
std::string why_torsion_is_idle(const scene::PreparedMachine& prepared, double slowest_hz);

/// Word in the status of a row whose rotor is unstable without its stops
/// (response::proof::RestProof::vibration_grows).
inline constexpr const char* unstable_rotor = "unstable_rotor";

/// One line on the speeds of the study at which the quiet motion is unstable, because a free vibration of the
/// rotor without its stops grows (structure::grows). Causes are cross-coupled bearings or rotating damping.
/// Empty where no vibration grows. Checks at most 400 speeds, and 16 machines along axes over keys, spread
/// evenly. `prepared` is the prepared study.machine. Throws ConfigError where the full matrices of a kit
/// contradict the result at the first, a middle or the last speed, or where the growth is fastest.
std::string where_rotor_is_unstable(const Study& study, const scene::PreparedMachine& prepared);

/// Advice to lower a key where `modes: auto` keeps so many modes of a rotor kit that cells become slow. One
/// line without a line end; empty where no advice is needed.
std::string describe_many_modes(const scene::PreparedMachine& prepared);

}  // namespace rubsweep::sweep
