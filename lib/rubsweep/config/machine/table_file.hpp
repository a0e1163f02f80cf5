#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "rubsweep/config/yaml/diagnostics.hpp"
#include "rubsweep/config/yaml/document.hpp"
#include "rubsweep/config/yaml/file_bytes.hpp"
#include "rubsweep/config/yaml/value.hpp"

namespace rubsweep::config::machine {

/// Puts the columns of a file in place of a map {file: NAME}, another node stays: text with a line of names
/// and lines of cells, parted by commas; blank lines and those that begin with # do not count. NAME is
/// relative to the file that it stands in. What cannot be had is a problem of the key, what is wrong in the
/// file one of its line.
void resolve_table_file(yaml::Node& table, const std::string& path, yaml::Diagnostics& diagnostics);

/// The bytes of the file that a value names, and that file, relative to the one in which the name stands.
/// Nothing after a problem.
std::optional<yaml::FileBytes> read_named_file(const yaml::Value& name, std::filesystem::path& file);

/// The node under a key of a map; null without one, or where `map` is no map.
yaml::Node* child(yaml::Node* map, std::string_view name);

}  // namespace rubsweep::config::machine
