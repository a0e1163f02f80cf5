#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/maps/config/yaml/alternatives.hpp"
#include "rubsweep/maps/config/yaml/diagnostics.hpp"
#include "rubsweep/maps/config/yaml/document.hpp"

namespace rubsweep::config::yaml {

/// Applies `key.path=value` strings in order. The value is YAML, and items of lists are given by number from
/// 0. Missing maps and keys on the path are created; the reader later refuses unknown keys. The place of a
/// value written here is the index of its override. Writing a key removes keys of the same map that exclude
/// it (stribeck and coefficient, values and from/to/count, ...). An override that cannot be applied becomes a
/// problem and changes no value.
void apply_overrides(Node& root, const std::vector<std::string>& overrides, const Alternatives& alternatives,
                     Diagnostics& diagnostics);

/// Writes one number as an override does. `place` is the place of the number and of its problems.
void write_number(Node& root, std::string_view path, double value, const SourcePosition& place,
                  const Alternatives& alternatives, Diagnostics& diagnostics);

/// Node at the end of a dotted path; null where the path does not exist.
const Node* find_node(const Node& root, std::string_view path);

}  // namespace rubsweep::config::yaml
