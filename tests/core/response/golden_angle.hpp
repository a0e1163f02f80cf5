#pragma once

namespace rubsweep::response {

inline constexpr double golden_angle = 2.39996322972865332;  ///< returns as badly as an angle can

}  // namespace rubsweep::response
