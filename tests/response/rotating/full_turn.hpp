#pragma once

#include <numbers>

namespace rubsweep::response::rotating {

inline constexpr double full_turn = 2 * std::numbers::pi;

}  // namespace rubsweep::response::rotating
