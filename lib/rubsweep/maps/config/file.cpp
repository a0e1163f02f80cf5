#include "rubsweep/maps/config/file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "rubsweep/maps/config/machine/shaft_matrices.hpp"
#include "rubsweep/maps/config/machine/support_table.hpp"
#include "rubsweep/maps/config/yaml/base.hpp"
#include "rubsweep/maps/config/yaml/override.hpp"

namespace rubsweep::config {

keys::Key base_of_map() {
  return newer_key(keys::may(std::string(yaml::base_key), keys::text(),
                             "file that this map is written over, relative to the one it stands in",
                             "(none)"));
}

void refuse_foreign(const yaml::Node& root, std::initializer_list<std::string_view> theirs,
                    std::initializer_list<std::string_view> ours, std::string_view program,
                    yaml::Diagnostics& diagnostics) {
  const auto among = [](const yaml::Node::Key& key, std::initializer_list<std::string_view> names) {
    return std::ranges::find(names, key.text) != names.end();
  };
  if (std::ranges::any_of(root.keys, [&](const yaml::Node::Key& key) { return among(key, ours); })) return;
  for (const yaml::Node::Key& key : root.keys) {
    if (!among(key, theirs)) continue;
    diagnostics.add(key.place, key.text, fmt::format("belongs to a configuration of {}", program),
                    fmt::format("{} with this file", program));
    diagnostics.throw_if_any();
  }
}

yaml::Node parse_config(std::string_view text, const std::filesystem::path& file, std::string_view form,
                        const std::vector<std::string>& overrides, yaml::Diagnostics& diagnostics) {
  auto root = parse_document(text, -1, "", diagnostics);
  diagnostics.throw_if_any();
  if (root->kind == yaml::Node::Kind::null) {
    diagnostics.add(yaml::SourcePosition{}, "", "the configuration is empty", form);
    diagnostics.throw_if_any();
  }
  if (!resolve_bases(*root, file, diagnostics)) diagnostics.throw_if_any();
  apply_overrides(*root, overrides, diagnostics);
  refuse_base_of_override(*root, diagnostics);
  machine::resolve_tables(*root, diagnostics);
  machine::resolve_matrices(*root, diagnostics);
  return *std::move(root);
}

}  // namespace rubsweep::config
