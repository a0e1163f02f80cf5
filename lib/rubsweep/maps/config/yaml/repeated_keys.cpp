#include "rubsweep/maps/config/yaml/repeated_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <string>

#include "rubsweep/maps/config/yaml/alternatives.hpp"
#include "rubsweep/maps/config/yaml/text.hpp"

namespace rubsweep::config::yaml {

void refuse_repeated_keys(const Node& map, std::string_view path, Diagnostics& diagnostics) {
  std::map<std::string_view, SourcePosition> first;
  for (const Node::Key& key : map.keys) {
    const auto [entry, is_new] = first.emplace(key.text, key.place);
    if (is_new) continue;
    const bool in_file = key.place.override_index < 0;
    const std::string first_line = in_file ? fmt::format(", first at line {}", entry->second.line) : "";
    diagnostics.add(key.place, child_path(path, key.text), "given again" + first_line, "each key once");
  }
}

void drop_repeated_keys(Node& map) {
  for (std::size_t i = map.keys.size(); i-- > 0;) {
    const auto is_equal = [&](const Node::Key& key) { return key.text == map.keys[i].text; };
    const auto end = map.keys.begin() + static_cast<std::ptrdiff_t>(i);
    if (std::any_of(map.keys.begin(), end, is_equal)) drop_entry(map, i);
  }
}

}  // namespace rubsweep::config::yaml
