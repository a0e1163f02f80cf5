#pragma once

#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/maps/config/keys/form.hpp"
#include "rubsweep/maps/config/yaml/diagnostics.hpp"
#include "rubsweep/maps/config/yaml/document.hpp"

namespace rubsweep::config {

/// Parses a configuration, writes it over its bases (see base.hpp; `file` is where they are looked for from)
/// and applies the overrides (see override.hpp), whose problems `diagnostics` collects. Throws ConfigError
/// when the text is no YAML document or nothing at all, `form` says what may stand there, and when a base
/// cannot be had.
yaml::Node parse_config(std::string_view text, const std::filesystem::path& file, std::string_view form,
                        const std::vector<std::string>& overrides, yaml::Diagnostics& diagnostics);

/// `base` of any map.
keys::Key base_of_map();

/// Refuses a configuration of another program, of which every key would be unknown: one that has a key of
/// `theirs` and none of `ours`. Throws ConfigError.
void refuse_foreign(const yaml::Node& root, std::initializer_list<std::string_view> theirs,
                    std::initializer_list<std::string_view> ours, std::string_view program,
                    yaml::Diagnostics& diagnostics);

}  // namespace rubsweep::config
