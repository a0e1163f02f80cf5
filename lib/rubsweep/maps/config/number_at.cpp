#include "rubsweep/maps/config/number_at.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>

#include "rubsweep/maps/config/file.hpp"
#include "rubsweep/maps/config/print_config.hpp"
#include "rubsweep/maps/config/yaml/diagnostics.hpp"
#include "rubsweep/maps/config/yaml/document.hpp"
#include "rubsweep/maps/config/yaml/file_bytes.hpp"
#include "rubsweep/maps/config/yaml/number.hpp"
#include "rubsweep/maps/config/yaml/override.hpp"

namespace rubsweep::config {
namespace {

const yaml::Node* child(const yaml::Node& node, std::string_view name) {
  if (node.kind == yaml::Node::Kind::map) {
    const auto found = std::ranges::find(node.keys, name, &yaml::Node::Key::text);
    return found == node.keys.end() ? nullptr
                                    : &node.items[static_cast<std::size_t>(found - node.keys.begin())];
  }
  std::size_t index = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), index);
  const bool is_index = error == std::errc{} && end == name.data() + name.size();
  return node.kind == yaml::Node::Kind::list && is_index && index < node.items.size() ? &node.items[index]
                                                                                      : nullptr;
}

}  // namespace

std::string place_of_key(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                         std::string_view path) {
  yaml::Diagnostics diagnostics(file.string(), overrides);
  const yaml::Node root = parse_config(yaml::read_config_bytes(file), file, "a map", overrides, diagnostics);
  const yaml::Node* node = find_node(root, path);
  return node == nullptr ? file.string() : diagnostics.describe(node->place);
}

std::optional<double> number_at(const RunConfig& config, std::string_view path) {
  yaml::Diagnostics diagnostics("", {});
  const auto root = parse_document(print_config(config), -1, "", diagnostics);
  const yaml::Node* node = root ? &*root : nullptr;
  while (node != nullptr) {
    const std::size_t dot = path.find('.');
    node = child(*node, path.substr(0, dot));
    if (dot == std::string_view::npos) break;
    path.remove_prefix(dot + 1);
  }
  if (node == nullptr || node->kind != yaml::Node::Kind::scalar || node->quoted) return std::nullopt;
  const yaml::ParsedNumber number = yaml::parse_number(node->text);
  return number.error == yaml::NumberError::none ? std::optional(number.value) : std::nullopt;
}

}  // namespace rubsweep::config
