#include "rubsweep/config/place_of_key.hpp"

#include "rubsweep/config/file.hpp"
#include "rubsweep/config/yaml/file_bytes.hpp"
#include "rubsweep/config/yaml/override.hpp"

namespace rubsweep::config {

std::string place_of_key(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                         std::string_view path) {
  yaml::Diagnostics diagnostics(file.string(), overrides);
  const yaml::Node root = parse_config(yaml::read_config_bytes(file), file, "a map", overrides, diagnostics);
  const yaml::Node* node = find_node(root, path);
  return node == nullptr ? file.string() : diagnostics.describe(node->place);
}

}  // namespace rubsweep::config
