#pragma once

#include "rubsweep/config/yaml/section.hpp"

namespace rubsweep::config::study {

/// Spacing of numbers from one end to the other.
enum class Scale { linear, log };
inline constexpr yaml::Words<Scale, 2> scales{{"linear", "log"}, {Scale::linear, Scale::log}};

}  // namespace rubsweep::config::study
