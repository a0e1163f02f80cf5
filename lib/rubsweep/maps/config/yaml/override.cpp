#include "rubsweep/maps/config/yaml/override.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <optional>
#include <utility>

#include "rubsweep/maps/config/yaml/text.hpp"
#include "rubsweep/maps/config/yaml/value.hpp"

namespace rubsweep::config::yaml {
namespace {

std::vector<std::string_view> split_path(std::string_view path) {
  std::vector<std::string_view> names;
  for (std::size_t dot = path.find('.'); dot != std::string_view::npos; dot = path.find('.')) {
    names.push_back(path.substr(0, dot));
    path.remove_prefix(dot + 1);
  }
  names.push_back(path);
  return names;
}

std::optional<std::size_t> index_in(const Node& list, std::string_view name) {
  std::size_t index = 0;
  const char* end = name.data() + name.size();
  const auto [stop, error] = std::from_chars(name.data(), end, index);
  return error == std::errc{} && stop == end && index < list.items.size() ? std::optional(index)
                                                                          : std::nullopt;
}

Node* item_of(Node& list, std::string_view name, const SourcePosition& place, const std::string& path,
              Diagnostics& diagnostics) {
  if (const auto index = index_in(list, name)) return &list.items[*index];
  const std::string allowed = list.items.empty()
                                  ? "nothing, the list is empty"
                                  : fmt::format("an index from 0 to {}", list.items.size() - 1);
  diagnostics.add(place, path, fmt::format("the list has no item '{}'", shown(name)), allowed);
  return nullptr;
}

Node* entry_of(Node& map, std::string_view name, const SourcePosition& place) {
  if (Node* found = entry(map, name)) return found;
  map.keys.push_back({std::string(name), place});
  map.items.push_back(Node{Node::Kind::map, place});
  return &map.items.back();
}

/// Node at the end of the path; missing keys on the way are created. Null after a problem was added.
Node* node_at(Node& root, std::string_view path, const SourcePosition& place,
              const Alternatives& alternatives, Diagnostics& diagnostics) {
  const auto names = split_path(path);
  if (std::find(names.begin(), names.end(), "") != names.end() || names.size() > max_document_depth) {
    diagnostics.add(place, "", fmt::format("'{}' is not a path", shown(path)),
                    fmt::format("1 to {} names or indices joined by dots", max_document_depth));
    return nullptr;
  }
  Node* node = &root;
  std::string walked;
  for (const std::string_view& name : names) {
    if (node->kind == Node::Kind::list) {
      node = item_of(*node, name, place, walked, diagnostics);
    } else if (node->kind == Node::Kind::map) {
      if (&name == &names.back()) alternatives.drop(*node, name);
      node = entry_of(*node, name, place);
    } else {
      const std::string found = node->kind == Node::Kind::null ? "has no value" : "is " + describe(*node);
      diagnostics.add(place, walked, fmt::format("{} and cannot hold '{}'", found, shown(name)),
                      "a map or a list");
      return nullptr;
    }
    if (node == nullptr) return nullptr;
    walked = child_path(walked, name);
  }
  return node;
}

void apply(Node& root, std::string_view text, int index, const Alternatives& alternatives,
           Diagnostics& diagnostics) {
  const SourcePosition place{index, 1, 1};
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos) {
    diagnostics.add(place, "", "there is no '='", "key.path=value");
    return;
  }
  const std::string_view path = text.substr(0, equals);
  auto value = parse_document(text.substr(equals + 1), index, shown(path), diagnostics);
  if (!value) return;
  if (Node* target = node_at(root, path, place, alternatives, diagnostics)) *target = std::move(*value);
}

}  // namespace

void apply_overrides(Node& root, const std::vector<std::string>& overrides, const Alternatives& alternatives,
                     Diagnostics& diagnostics) {
  for (std::size_t i = 0; i < overrides.size(); ++i) {
    apply(root, overrides[i], static_cast<int>(i), alternatives, diagnostics);
  }
}

void write_number(Node& root, std::string_view path, double value, const SourcePosition& place,
                  const Alternatives& alternatives, Diagnostics& diagnostics) {
  if (Node* target = node_at(root, path, place, alternatives, diagnostics)) {
    *target = Node{.kind = Node::Kind::scalar, .place = place, .text = fmt::format("{}", value)};
  }
}

const Node* find_node(const Node& root, std::string_view path) {
  const Node* node = &root;
  for (const std::string_view& name : split_path(path)) {
    const auto index = node->kind == Node::Kind::list ? index_in(*node, name) : std::nullopt;
    node = index ? &node->items[*index] : entry(*node, name);
    if (node == nullptr) return nullptr;
  }
  return node;
}

}  // namespace rubsweep::config::yaml
