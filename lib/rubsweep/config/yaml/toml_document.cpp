#include "rubsweep/config/yaml/toml_document.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <string>
#include <utility>

#include "rubsweep/config/yaml/text.hpp"

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
  try {
    Node root = TreeCopy(file).copy(toml::parse(text));
    if (count_nodes(root) <= max_document_nodes && depth_of(root) <= max_document_depth) return root;
    diagnostics.add(top, path, "too many values, or too deep ones",
                    fmt::format("at most {} values in {} levels", max_document_nodes, max_document_depth));
  } catch (const toml::parse_error& error) {
    const auto& at = error.source().begin;
    diagnostics.add({-1, static_cast<int>(at.line), static_cast<int>(at.column), file}, path,
                    fmt::format("no TOML: {}", shown(error.description(), 200)), "a TOML document");
  }
  return std::nullopt;
}

}  // namespace rubsweep::config::yaml
