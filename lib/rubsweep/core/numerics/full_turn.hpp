#pragma once

#include <numbers>

namespace rubsweep::numerics {

inline constexpr double full_turn = 2 * std::numbers::pi;  ///< rad

}  // namespace rubsweep::numerics
