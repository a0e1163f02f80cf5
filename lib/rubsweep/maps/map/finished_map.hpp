#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

#include "rubsweep/maps/batch/journal.hpp"
#include "rubsweep/maps/report/map_summary.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::map {

/// A map.csv as an earlier run left it.
struct FinishedMap {
  std::string digest;         ///< digest of its study; empty: it says none, and is no map of this program
  bool known_columns = true;  ///< false: the version that wrote it had other columns
  std::size_t cells = 0;
  std::string missing;         ///< the first cell without a row, where a map must have all
  report::MapSummary summary;  ///< summary of known columns
};

/// Throws DamagedTable where the table at `path` is not as it was written, IoError; warns on stderr as
/// `program` where it has no checksum to compare.
void require_whole_table(std::string_view program, const std::filesystem::path& path);

/// Reads the map of `study` a row at a time; its summary warns above so many clearances. For a map of another
/// study only the digest is read. Throws IoError, also where a row is no cell of the study or occurs twice,
/// and as require_whole_table.
FinishedMap read_finished_map(std::string_view program, const std::filesystem::path& map,
                              const sweep::Study& study, double warn_over_clearances);

/// Warns on stderr of conditions that make the numbers of a whole map doubtful.
void warn(std::string_view program, const report::MapSummary& summary);

/// Message of `program` on stderr where it finds the whole map of its study.
std::string map_is_there(std::string_view program);

/// Throws ConfigError where `there`, found at `map`, is not the whole map of the study of `here`, with both
/// digests and every key that differs as far as the config.yaml beside it tells.
void refuse_map_of_another(const FinishedMap& there, const std::filesystem::path& map,
                           const batch::JournalHeader& here);

}  // namespace rubsweep::map
