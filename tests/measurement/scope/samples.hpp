#pragma once

namespace rubsweep::scope {

inline constexpr int samples = 128;  ///< samples per turn

}  // namespace rubsweep::scope
