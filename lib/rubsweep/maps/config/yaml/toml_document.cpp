#include "rubsweep/maps/config/yaml/toml_document.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cctype>
#include <string>
#include <utility>

#include "rubsweep/maps/config/yaml/text.hpp"

namespace rubsweep::config::yaml {
namespace {

/// Copies toml++'s tree, whose maps are sorted by key.
class TreeCopy {
 public:
  explicit TreeCopy(int file) : file_(file) {}

  Node copy(const toml::node& from) const {
    Node node{Node::Kind::scalar, place(from.source())};
    if (const toml::table* table = from.as_table()) {
      copy_entries(*table, node);
    } else if (const toml::array* array = from.as_array()) {
      node.kind = Node::Kind::list;
      for (const toml::node& item : *array) node.items.push_back(copy(item));
    } else {
      copy_scalar(from, node);
    }
    return node;
  }

 private:
  SourcePosition place(const toml::source_region& region) const {
    return {-1, static_cast<int>(region.begin.line), static_cast<int>(region.begin.column), file_};
  }

  void copy_entries(const toml::table& table, Node& node) const {
    node.kind = Node::Kind::map;
    std::vector<std::pair<Node::Key, const toml::node*>> entries;
    for (const auto& [key, value] : table)
      entries.push_back({{std::string(key.str()), place(key.source())}, &value});
    std::ranges::stable_sort(entries, {}, [](const auto& entry) { return entry.first.place; });
    for (auto& [key, value] : entries) {
      node.keys.push_back(std::move(key));
      node.items.push_back(copy(*value));
    }
  }

  /// Numbers in the shortest form that reads back the same.
  static void copy_scalar(const toml::node& from, Node& node) {
    if (const auto* number = from.as_floating_point()) {
      node.text = fmt::format("{}", number->get());
    } else if (const auto* integer = from.as_integer()) {
      node.text = fmt::format("{}", integer->get());
    } else if (const auto* flag = from.as_boolean()) {
      node.text = flag->get() ? "true" : "false";
    } else {
      node.text = from.as_string() != nullptr ? from.as_string()->get() : "a date or time";
      node.quoted = true;
    }
  }

  int file_;
};

/// Where a key of more parts than levels are allowed, or a bracket that deep, stands. The parser makes a
/// table of each part and takes them apart one inside another, which a long key would end with the stack.
/// Strings and comments are passed over; in a text that is no TOML the parser stops before it is misled.
std::optional<SourcePosition> too_deep(std::string_view text, int file) {
  std::size_t parts = 1, brackets = 0, line_begin = 0;
  int line = 1;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '#') {
      i = std::min(text.find('\n', i), text.size()) - 1;
    } else if (c == '"' || c == '\'') {
      const bool block = text.substr(i, 3) == std::string(3, c);
      for (i += block ? 3 : 1; i < text.size(); ++i) {
        if (text[i] == '\n') line_begin = i + 1, ++line;
        if (c == '"' && text[i] == '\\')
          ++i;
        else if (block ? text.substr(i, 3) == std::string(3, c) : text[i] == c || text[i] == '\n')
          break;
      }
      i += block ? 2 : 0;
    } else {
      if (c == '\n') line_begin = i + 1, ++line;
      const bool of_key =
          std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == ' ' || c == '\t';
      parts = c == '.' ? parts + 1 : of_key ? parts : 1;
      if (c == '[' || c == '{') ++brackets;
      if ((c == ']' || c == '}') && brackets > 0) --brackets;
    }
    if (parts > max_document_depth || brackets > max_document_depth)
      return SourcePosition{-1, line, static_cast<int>(i - line_begin) + 1, file};
  }
  return std::nullopt;
}

std::size_t depth_of(const Node& node) {
  std::size_t depth = 0;
  for (const Node& item : node.items) depth = std::max(depth, depth_of(item) + 1);
  return depth;
}

}  // namespace

std::optional<Node> parse_toml(std::string_view text, std::string_view path, Diagnostics& diagnostics,
                               int file) {
  const SourcePosition top{-1, 1, 1, file};
  if (text.size() > max_document_bytes) {
    diagnostics.add(top, path, "the file is too large", fmt::format("at most {} bytes", max_document_bytes));
    return std::nullopt;
  }
  const auto refuse_extent = [&](const SourcePosition& place) {
    diagnostics.add(place, path, "too many values, or too deep ones",
                    fmt::format("at most {} values in {} levels", max_document_nodes, max_document_depth));
    return std::nullopt;
  };
  if (const auto place = too_deep(text, file)) return refuse_extent(*place);
  try {
    Node root = TreeCopy(file).copy(toml::parse(text));
    if (count_nodes(root) <= max_document_nodes && depth_of(root) <= max_document_depth) return root;
    return refuse_extent(top);
  } catch (const toml::parse_error& error) {
    const auto& at = error.source().begin;
    diagnostics.add({-1, static_cast<int>(at.line), static_cast<int>(at.column), file}, path,
                    fmt::format("no TOML: {}", shown(error.description(), 200)), "a TOML document");
  }
  return std::nullopt;
}

}  // namespace rubsweep::config::yaml
