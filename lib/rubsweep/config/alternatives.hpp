#pragma once

#include <string_view>

#include "rubsweep/config/document.hpp"

namespace rubsweep::config {

/// Removes from a map the keys that say by other means what the key `written` says (stribeck and coefficient,
/// values and from/to/count, ...): what is written over a map takes them back.
void drop_alternatives(Node& map, std::string_view written);

/// Removes one key of a map and its value.
void drop_entry(Node& map, std::size_t index);

}  // namespace rubsweep::config
