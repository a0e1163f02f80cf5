#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rubsweep::config::templates {

/// Kinds of machines that there is a configuration to begin with for: one_side, both_sides, annular,
/// rotor_kit, ross.
std::vector<std::string_view> template_names();

/// Configuration of such a machine, complete and with comments that say where each number comes from; it
/// names the schema beside it, rubsweep.schema.json. Empty where the name is none of template_names.
std::optional<std::string> template_text(std::string_view name);

}  // namespace rubsweep::config::templates
