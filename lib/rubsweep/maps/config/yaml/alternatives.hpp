#pragma once

#include <string_view>

#include "rubsweep/maps/config/yaml/diagnostics.hpp"
#include "rubsweep/maps/config/yaml/document.hpp"

namespace rubsweep::config::yaml {

/// Removes from a map the keys that are alternatives to the key `written` (stribeck and coefficient, values
/// and from/to/count, ...): a value written over a map replaces them.
void drop_alternatives(Node& map, std::string_view written);

/// Removes one key of a map and its value.
void drop_entry(Node& map, std::size_t index);

/// Adds a problem for every key of the map at `path` that was given before in the same map.
void refuse_repeated_keys(const Node& map, std::string_view path, Diagnostics& diagnostics);

/// Leaves only the first of equal keys in a map: after the others were refused, so that they are not again.
void drop_repeated_keys(Node& map);

}  // namespace rubsweep::config::yaml
