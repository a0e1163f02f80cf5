#include "rubsweep/maps/config/line_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>

#include "rubsweep/maps/batch/csv_table.hpp"
#include "rubsweep/maps/config/file.hpp"
#include "rubsweep/maps/config/study/axis.hpp"
#include "rubsweep/maps/config/yaml/base.hpp"
#include "rubsweep/maps/config/yaml/diagnostics.hpp"
#include "rubsweep/maps/config/yaml/document.hpp"
#include "rubsweep/maps/config/yaml/override.hpp"
#include "rubsweep/maps/config/yaml/text.hpp"

namespace rubsweep::config {
namespace {

/// Whether an override writes the key itself or a map that contains it.
bool is_named(std::string_view key, const std::vector<std::string>& overrides) {
  return std::ranges::any_of(overrides, [&](std::string_view text) {
    const std::string_view path = text.substr(0, text.find('='));
    return key == path || (key.starts_with(path) && key.substr(path.size()).starts_with('.'));
  });
}

/// Factor of an axis for one of its keys; 0 for a key that the axis does not have.
double factor_of(const sweep::KeyAxis& axis, std::string_view key) {
  const auto found = std::ranges::find(axis.keys, key);
  return found == axis.keys.end() ? 0 : axis.factors[static_cast<std::size_t>(found - axis.keys.begin())];
}

}  // namespace

bool are_named(const sweep::KeyAxis& axis, const std::vector<std::string>& overrides) {
  return std::ranges::all_of(axis.keys, [&](const std::string& key) { return is_named(key, overrides); });
}

LineKeys line_keys(const sweep::Grid& grid, std::string_view along, const std::filesystem::path& file,
                   const std::vector<std::string>& overrides,
                   const std::vector<std::string>& said_elsewhere) {
  LineKeys keys;
  if (grid.axes.empty()) return keys;
  yaml::Diagnostics diagnostics(file.string(), overrides);
  const yaml::Node root =
      parse_config(yaml::read_config_bytes(file), file, "", overrides, diagnostics, run_alternatives());
  std::vector<std::string> named = overrides;
  named.insert(named.end(), said_elsewhere.begin(), said_elsewhere.end());
  std::size_t next = 0;
  for (const std::string_view name : study::key_axis_names) {
    const yaml::Node* node = find_node(root, fmt::format("sweep.{}", name));
    if (node == nullptr) continue;
    const sweep::KeyAxis& axis = grid.axes.at(next++);
    if (const double factor = factor_of(axis, along); factor != 0) {
      keys.along = axis;
      keys.factor = factor;
    } else if (are_named(axis, named)) {
      continue;
    } else if (axis.values.size() == 1) {
      std::ranges::move(sweep::keys_at(axis, axis.values.front()), std::back_inserter(keys.fixed));
    } else {
      const std::string& key = axis.keys.front();
      const std::string set = fmt::format("--set {}=VALUE", key),
                        of_axis = fmt::format("--set sweep.{}.values=[VALUE]", name);
      diagnostics.add(
          node->place, fmt::format("sweep.{}", name),
          fmt::format("{} has {} values, and {}", key, axis.values.size(),
                      along.empty() ? "a cell has one" : fmt::format("the line runs along {}", along)),
          along.empty() ? fmt::format("{} or {}", set, of_axis)
                        : fmt::format("{}, {}, or --along {}", set, of_axis, key));
    }
  }
  diagnostics.throw_if_any();
  return keys;
}

RunConfig read_cell_config(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                           const std::vector<std::string>& said_elsewhere) {
  RunConfig config = read_run_config(file, overrides);
  if (config.study.grid.axes.empty()) return config;
  const LineKeys keys = line_keys(config.study.grid, "", file, overrides, said_elsewhere);
  std::vector<std::string> written = overrides;
  for (const sweep::KeyValue& fixed : keys.fixed)
    written.push_back(fixed.key + "=" + batch::csv_number(fixed.value));
  if (!keys.fixed.empty()) config = read_run_config(file, written);
  config.study.grid.axes.clear();
  config.study.with_keys = {};
  return config;
}

std::string place_of_key(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                         std::string_view path) {
  yaml::Diagnostics diagnostics(file.string(), overrides);
  const yaml::Node root =
      parse_config(yaml::read_config_bytes(file), file, "a map", overrides, diagnostics, run_alternatives());
  const yaml::Node* node = find_node(root, path);
  return node == nullptr ? file.string() : diagnostics.describe(node->place);
}

std::optional<double> number_at(const RunConfig& config, std::string_view path) {
  yaml::Diagnostics diagnostics("", {});
  const auto root = parse_document(print_config(config), -1, "", diagnostics);
  const yaml::Node* node = root ? find_node(*root, path) : nullptr;
  return node == nullptr ? std::nullopt : yaml::number_of(*node);
}

}  // namespace rubsweep::config
