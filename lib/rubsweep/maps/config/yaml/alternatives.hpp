#pragma once

#include <string_view>

#include "rubsweep/maps/config/yaml/diagnostics.hpp"
#include "rubsweep/maps/config/yaml/document.hpp"

namespace rubsweep::config::yaml {

/// Removes the keys of a map that exclude the key `written` (stribeck and coefficient, values and
/// from/to/count, ...), because a value written over the map replaces them.
void drop_alternatives(Node& map, std::string_view written);

/// Removes one key of a map and its value.
void drop_entry(Node& map, std::size_t index);

/// Adds a problem for every repeated key of the map at `path`.
void refuse_repeated_keys(const Node& map, std::string_view path, Diagnostics& diagnostics);

/// Leaves only the first of equal keys in a map. Called after they were reported, so that they are not
/// reported twice.
void drop_repeated_keys(Node& map);

}  // namespace rubsweep::config::yaml
