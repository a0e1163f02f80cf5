#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/maps/batch/file_lock.hpp"
#include "rubsweep/maps/batch/journal.hpp"
#include "rubsweep/maps/batch/table_file.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/map/earlier_results.hpp"
#include "rubsweep/maps/map/map_files.hpp"
#include "rubsweep/maps/report/map_summary.hpp"

namespace rubsweep::map {

/// Directory of one map while a process works there. Files:
/// - map.csv, the result, which appears only when complete, and config.yaml, the complete configuration
/// - `NAME.journal`: finished cells of one process, until they are in map.csv
/// - `NAME.partial.csv`: the same cells for people to read
/// - `NAME.lock`: lock of the process at work; `map.begin.lock`: lock of a process that is about to begin
/// NAME is `map`, or `map.shard-I-of-N` for a part, or `map.rank-R`.
class MapDirectory {
 public:
  /// Begins work on a share of the map, or continues it. `fresh`: first removes finished cells and a finished
  /// map, even those of other configurations. `program`: name of the program, for the lock. Throws
  /// LockedError where another process is at work there, ConfigError where the finished cells belong to
  /// another configuration or program, and IoError. After an exception the directory is unchanged.
  MapDirectory(std::filesystem::path directory, const config::RunConfig& config, std::optional<Share> part,
               bool fresh, const std::string& program);

  std::size_t cells() const { return cells_; }                       ///< cells of the share
  std::size_t finished() const { return cells_ - missing_.size(); }  ///< finished before this run
  const std::vector<std::size_t>& missing() const { return missing_; }

  /// Whether the cell belongs to this share.
  bool has_in_share(std::size_t cell) const { return share_of(cell) == part_.value_or(Share{}).index; }

  /// Index, from 0, of the shard to which a cell belongs if the map is divided into `count` shards.
  std::size_t share_in(std::size_t cell, std::size_t count) const;

  /// Number of shards in the finest division of which a shard was begun here; 0 where none was.
  std::size_t shards_begun() const;

  /// Whether another process is at work on a share with one of these cells. Throws IoError.
  bool is_at_work_on(const std::vector<std::size_t>& cells) const;

  /// Whole map of this study, if an earlier run finished it; no work then remains.
  const std::optional<FinishedMap>& finished_map() const { return finished_map_; }

  /// Opens the journal of this process, to which finished cells are added. Throws IoError.
  batch::Journal journal() const { return {path(".journal"), header_}; }

  /// File in which people can watch finished cells. It begins with those that were finished when the work
  /// began.
  std::filesystem::path partial() const { return path(".partial.csv"); }

  /// Calls `visit` with every finished cell and its line, ascending. Throws IoError.
  void for_each_finished(const std::function<void(std::size_t cell, const std::string& line)>& visit) const;

  /// Writes map.csv from all journals, then removes the journals. Call it only when no cell is missing, or
  /// when a refined map needs no more cells. Throws IoError.
  report::MapSummary write_map() const;

  std::filesystem::path map() const { return directory_ / "map.csv"; }

  /// Writes painted.csv beside a refined map if it is missing (see write_painted_map). Does nothing for any
  /// other map. `grid` is the grid of the study. Throws IoError.
  void paint(const sweep::Grid& grid) const;

  /// Line of a finished cell in map.csv: its line in a journal, with the columns in units of the
  /// configuration added.
  std::string in_map(const std::string& line) const;

  /// Removes the locks, for a process that ends at once, so that others may work in the directory.
  void leave();

 private:
  std::filesystem::path path(std::string_view ending) const;
  std::size_t share_of(std::size_t cell) const;
  std::vector<std::filesystem::path> journals() const;
  void lock(const std::string& program);
  void lock_share(const std::string& program);
  void refuse_what_is_no_file() const;
  void remove_leftovers() const;
  void forget() const;
  bool belongs_to_other_part(const std::filesystem::path& journal) const;
  void refuse_journals_of_others() const;
  void read_journals();
  void write_partial(const batch::FinishedCells& finished) const;
  void remove_journals() const;

  std::filesystem::path directory_;
  std::string name_;
  std::optional<Share> part_;
  batch::JournalHeader header_;
  batch::TableSource source_;
  std::string head_;  ///< text of the map between the head of every table and the rows
  double warn_over_clearances_ = 0;
  sweep::Grid written_;  ///< grid of the configuration, used only for the units of its axes
  std::optional<batch::FileLock> own_lock_, directory_lock_;
  std::size_t cells_ = 0;
  std::vector<std::size_t> missing_;
  std::optional<FinishedMap> finished_map_;
  bool refined_ = false;  ///< true: the map has only some of the cells
};

/// Opens a journal for another process, MPI rank `rank`, that helps the owner of the MapDirectory. Throws
/// IoError.
batch::Journal rank_journal(const config::RunConfig& config, int rank);

}  // namespace rubsweep::map
