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

/// Kinds of machines that there is a configuration to begin with for: one_side, both_sides, annular,
/// rotor_kit, ross.
std::vector<std::string_view> template_names();

/// Configuration of such a machine, complete and with comments that say where each number comes from; it
/// names the schema beside it, rubsweep.schema.json. Empty where the name is none of template_names.
std::optional<std::string> template_text(std::string_view name);

}  // namespace rubsweep::config::templates
