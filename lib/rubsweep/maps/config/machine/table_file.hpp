#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "rubsweep/maps/config/yaml/base.hpp"
#include "rubsweep/maps/config/yaml/diagnostics.hpp"
#include "rubsweep/maps/config/yaml/document.hpp"
#include "rubsweep/maps/config/yaml/value.hpp"
#include "rubsweep/maps/table/cell.hpp"

namespace rubsweep::config::machine {

/// Columns of a file of bearing characteristics as ANSYS imports it, by the keys of a table of supports: up
/// to three lines of titles, then how many speeds there are and two flags, and for each speed a line with its
/// number and speed, one with K11, K12, K21, K22 and one with C11, C12, C21, C22. The first flag is 1 for
/// lbf/in and lbf s/in, 0 for N/m and N s/m; the second is 1 for rpm, 0 for rad/s; one that is left out is 1.
/// Nothing for another text. Throws table::Fault for such a file that is not whole. `file`: see
/// yaml::SourcePosition.
std::optional<yaml::Node> read_ansys_bearing(std::string_view text, int file);

/// Key that a column is read under; empty: its name is none of the known ones. What is `wrong` is that of a
/// known name with a unit that it cannot have.
struct ColumnKey {
  std::string key{}, wrong{}, allowed{};
};
using KeyOf = std::function<ColumnKey(const table::Heading&)>;

/// Puts the columns of a file in place of a map {file: NAME}, another node stays: a table as people have it
/// (table/layout.hpp), with a line of names some of which are known, units behind the names or in a line
/// below them, and lines of cells; columns of other names that hold words are comments, rows of empty cells
/// do not count. NAME is relative to the file that it stands in. What cannot be had is a problem of the key,
/// what is wrong in the file one of its line.
void resolve_table_file(yaml::Node& table, const std::string& path, const KeyOf& key_of,
                        yaml::Diagnostics& diagnostics);

/// The bytes of the file that a value names, and that file, relative to the one in which the name stands.
/// Nothing after a problem.
std::optional<yaml::FileBytes> read_named_file(const yaml::Value& name, std::filesystem::path& file);

/// The node under a key of a map; null without one, or where `map` is no map.
yaml::Node* child(yaml::Node* map, std::string_view name);

}  // namespace rubsweep::config::machine
