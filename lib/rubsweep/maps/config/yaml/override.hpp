#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/maps/config/yaml/alternatives.hpp"
#include "rubsweep/maps/config/yaml/diagnostics.hpp"
#include "rubsweep/maps/config/yaml/document.hpp"

namespace rubsweep::config::yaml {

/// Applies `key.path=value` strings in order: the value is YAML, lists are indexed by number from 0, and maps
/// and keys that are missing on the way are created (the reader refuses those it does not know). What an
/// override wrote has its index as place. Writing a key takes back the keys beside it that exclude it
/// (stribeck and coefficient, values and from/to/count, ...). An override that cannot be applied becomes a
/// problem and changes no value.
void apply_overrides(Node& root, const std::vector<std::string>& overrides, const Alternatives& alternatives,
                     Diagnostics& diagnostics);

/// Writes one number as an override does. `place` is that of the number and of the problems.
void write_number(Node& root, std::string_view path, double value, const SourcePosition& place,
                  const Alternatives& alternatives, Diagnostics& diagnostics);

/// The node at the end of a dotted path; null where there is none.
const Node* find_node(const Node& root, std::string_view path);

}  // namespace rubsweep::config::yaml
