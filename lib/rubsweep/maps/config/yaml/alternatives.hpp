#pragma once

#include <string_view>

#include "rubsweep/maps/config/yaml/document.hpp"

namespace rubsweep::config::yaml {

/// Removes from a map the keys that are alternatives to the key `written` (stribeck and coefficient, values
/// and from/to/count, ...): a value written over a map replaces them.
void drop_alternatives(Node& map, std::string_view written);

/// Removes one key of a map and its value.
void drop_entry(Node& map, std::size_t index);

}  // namespace rubsweep::config::yaml
