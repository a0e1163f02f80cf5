#pragma once

namespace rubsweep::response {

inline constexpr double golden_angle = 2.39996322972865332;  ///< rad; its multiples never nearly return

}  // namespace rubsweep::response
