#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace rubsweep::config::templates {

/// A file that the build put into the program, and its name without an ending.
struct Text {
  std::string_view name, yaml;
};

inline constexpr std::size_t text_count = 5;

/// The files of configs/init.
extern const std::array<Text, text_count> texts;

}  // namespace rubsweep::config::templates
