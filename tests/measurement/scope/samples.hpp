#pragma once

namespace rubsweep::scope {

inline constexpr int samples = 128;  ///< samples of a turn

}  // namespace rubsweep::scope
