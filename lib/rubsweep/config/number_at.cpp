#include "rubsweep/config/number_at.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>

#include "rubsweep/config/diagnostics.hpp"
#include "rubsweep/config/document.hpp"
#include "rubsweep/config/number.hpp"
#include "rubsweep/config/print_config.hpp"

namespace rubsweep::config {
namespace {

const Node* child(const Node& node, std::string_view name) {
  if (node.kind == Node::Kind::map) {
    const auto found = std::ranges::find(node.keys, name, &Node::Key::text);
    return found == node.keys.end() ? nullptr
                                    : &node.items[static_cast<std::size_t>(found - node.keys.begin())];
  }
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), index);
  const bool is_index = error == std::errc{} && end == name.data() + name.size();
  return node.kind == Node::Kind::list && is_index && index < node.items.size() ? &node.items[index]
                                                                                : nullptr;
}

}  // namespace

std::optional<double> number_at(const RunConfig& config, std::string_view path) {
  Diagnostics diagnostics("", {});
  const auto root = parse_document(print_config(config), -1, "", diagnostics);
  const Node* node = root ? &*root : nullptr;
  while (node != nullptr) {
    const std::size_t dot = path.find('.');
    node = child(*node, path.substr(0, dot));
    if (dot == std::string_view::npos) break;
    path.remove_prefix(dot + 1);
  }
  if (node == nullptr || node->kind != Node::Kind::scalar || node->quoted) return std::nullopt;
  const ParsedNumber number = parse_number(node->text);
  return number.error == NumberError::none ? std::optional(number.value) : std::nullopt;
}

}  // namespace rubsweep::config
