#pragma once

namespace rubsweep::scope {

inline constexpr int samples = 128;  ///< of a turn

}  // namespace rubsweep::scope
