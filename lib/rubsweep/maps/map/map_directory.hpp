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

/// The directory of one map while a process is at work there:
/// - map.csv, the result, only ever whole, and config.yaml, the complete configuration;
/// - `NAME.journal`: finished cells as one process wrote them, until they are in map.csv;
/// - `NAME.partial.csv`: the same cells to look at;
/// - `NAME.lock`: says who is at work; `map.begin.lock`: who is about to begin.
/// NAME is `map`, or `map.shard-I-of-N` for a part, or `map.rank-R`.
class MapDirectory {
 public:
  /// Begins work on a share, or continues it; `fresh`: after removing finished cells, a finished map and
  /// results of other configurations included. `program` is the name in the lock. Throws LockedError when
  /// another process is at work there, ConfigError when the finished cells belong to another configuration or
  /// program, IoError; then everything there is as it was.
  MapDirectory(std::filesystem::path directory, const config::RunConfig& config, std::optional<Share> part,
               bool fresh, const std::string& program);

  std::size_t cells() const { return cells_; }                       ///< cells of the share
  std::size_t finished() const { return cells_ - missing_.size(); }  ///< number when the work began
  const std::vector<std::size_t>& missing() const { return missing_; }

  /// Whether the cell is one of the share.
  bool has_in_share(std::size_t cell) const { return share_of(cell) == part_.value_or(Share{}).index; }

  /// The shard, from 0, that has the cell in a division into `count` of them.
  std::size_t share_in(std::size_t cell, std::size_t count) const;

  /// How many shards the division has of which one was begun here, the finest of several; 0 where none was.
  std::size_t shards_begun() const;

  /// Whether another process is at work on a share that has one of these cells. Throws IoError.
  bool is_at_work_on(const std::vector<std::size_t>& cells) const;

  /// The whole map of this study, where an earlier run left it: then there is nothing to do, and no cell is
  /// missing.
  const std::optional<FinishedMap>& finished_map() const { return finished_map_; }

  /// Opens the journal of this process to add finished cells. Throws IoError.
  batch::Journal journal() const { return {path(".journal"), header_}; }

  /// File in which finished cells can be watched: holds those that were finished when the work began.
  std::filesystem::path partial() const { return path(".partial.csv"); }

  /// Every finished cell with its line, ascending. Throws IoError.
  void for_each_finished(const std::function<void(std::size_t cell, const std::string& line)>& visit) const;

  /// Writes map.csv from every journal and removes those; only when no cell is missing, or when a refined map
  /// wants no more. Throws IoError.
  report::MapSummary write_map() const;

  std::filesystem::path map() const { return directory_ / "map.csv"; }

  /// Writes painted.csv beside a refined map that has none (see write_painted_map); nothing for any other
  /// map. The grid is that of the study. Throws IoError.
  void paint(const sweep::Grid& grid) const;

  /// A finished cell as the map shows it: its line in a journal, and numbers in the units of the person.
  std::string in_map(const std::string& line) const;

  /// Frees the directory for others, for a process that ends at once.
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
  std::string head_;  ///< head of the map: what stands between the head of every table and its rows
  double warn_over_clearances_ = 0;
  sweep::Grid written_;  ///< only how its axes are written
  std::optional<batch::FileLock> own_lock_, directory_lock_;
  std::size_t cells_ = 0;
  std::vector<std::size_t> missing_;
  std::optional<FinishedMap> finished_map_;
  bool refined_ = false;  ///< the map holds some of the cells
};

/// Opens the journal of another process that helps the one whose MapDirectory this is. Throws IoError.
batch::Journal rank_journal(const config::RunConfig& config, int rank);

}  // namespace rubsweep::map
