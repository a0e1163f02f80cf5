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

/// Columns of a file of bearing characteristics as ANSYS imports it, under the keys of a table of supports.
/// The file has up to three lines of titles, then a line with the number of speeds and two flags. Three lines
/// follow for each speed: its number and the speed; K11, K12, K21, K22; C11, C12, C21, C22. The first flag is
/// 1 for lbf/in and lbf s/in, 0 for N/m and N s/m. The second flag is 1 for rpm, 0 for rad/s. A flag that is
/// left out is 1. Empty for any other text. Throws table::Fault for such a file that is incomplete. `file`:
/// see yaml::SourcePosition.
std::optional<yaml::Node> read_ansys_bearing(std::string_view text, int file);

/// Key under which a column is read; empty where the name of the column is unknown. `wrong` is the problem of
/// a known name with a unit that it cannot have.
struct ColumnKey {
  std::string key{}, wrong{}, allowed{};
};
using KeyOf = std::function<ColumnKey(const table::Heading&)>;

/// Replaces a map {file: NAME} by the columns of that file, and leaves any other node unchanged. The file is
/// a table as people write it (table/layout.hpp): a line of names, some of them known, with units behind the
/// names or in the line below, then lines of cells. Columns that have an unknown name and hold words are
/// comments, and rows of empty cells are ignored. NAME is relative to the file in which it stands. A file
/// that cannot be read is a problem of the key, an error inside it a problem of its line.
void resolve_table_file(yaml::Node& table, const std::string& path, const KeyOf& key_of,
                        yaml::Diagnostics& diagnostics);

/// Bytes of the file that a value names; `file` becomes its path, which is relative to the file in which the
/// name stands. Empty after a problem.
std::optional<yaml::FileBytes> read_named_file(const yaml::Value& name, std::filesystem::path& file);

/// Node under a key of a map; null where the key is missing or `map` is no map.
yaml::Node* child(yaml::Node* map, std::string_view name);

}  // namespace rubsweep::config::machine
