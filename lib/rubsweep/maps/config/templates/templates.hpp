#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rubsweep::config::templates {

/// A file that the build put into the program, and its name without an ending.
struct Text {
  std::string_view name, yaml;
};

inline constexpr std::size_t text_count = 5;

/// The files of configs/init.
extern const std::array<Text, text_count> texts;

/// Kinds of machines that have a template: one_side, both_sides, annular, rotor_kit, ross.
std::vector<std::string_view> template_names();

/// Complete configuration for a template name, with comments on the source of each number. Its first line
/// names the schema rubsweep.schema.json in the same directory. Empty for any name that template_names does
/// not list.
std::optional<std::string> template_text(std::string_view name);

}  // namespace rubsweep::config::templates
