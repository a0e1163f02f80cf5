#pragma once

#include <numbers>

namespace rubsweep::numerics {

inline constexpr double full_turn = 2 * std::numbers::pi;  ///< one revolution in rad

}  // namespace rubsweep::numerics
