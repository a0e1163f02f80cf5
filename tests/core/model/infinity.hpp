#pragma once

#include <limits>

namespace rubsweep::model {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace rubsweep::model
