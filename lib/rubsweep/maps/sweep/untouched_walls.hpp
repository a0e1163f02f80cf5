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

/// Where a weak kick is why, force in newtons from which on that bound lets some cell touch, within 1 %: a kick
/// below it touches nothing, one above may. Empty where there is another reason or none, where the kick has no
/// force, and where no force up to 1e9 times its own is enough.
std::optional<double> least_kick_force_n(const Study& study, const scene::PreparedMachine& prepared);

}  // namespace rubsweep::sweep
