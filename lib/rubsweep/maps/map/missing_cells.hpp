#pragma once

#include <atomic>
#include <cstddef>
#include <filesystem>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/maps/batch/journal.hpp"
#include "rubsweep/maps/batch/progress.hpp"
#include "rubsweep/maps/batch/whole_file.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/map/map_directory.hpp"
#include "rubsweep/maps/report/map_summary.hpp"
#include "rubsweep/maps/sweep/row.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::map {

/// Finished cells on their way into the journal of this process, into the partial map and into the line of
/// progress on stderr. Not for several threads at once.
class CellLog {
 public:
  /// Opens both files; the directory must outlive it. Throws IoError.
  CellLog(const MapDirectory& directory, batch::ProgressMode mode);

  /// Writes down a cell with its line of the map, and the seconds that it took on its thread. Throws IoError.
  void add(std::size_t cell, const std::string& line, std::optional<double> seconds = {});

  /// Counts and shows a cell that the journal of another process holds.
  void add_of_other_process(std::size_t cell, const std::string& line);

  /// Number of added cells.
  std::size_t finished() const { return finished_; }

  batch::Progress& progress() { return progress_; }

  /// Redraws the progress and asks for the journal to be on the disk, each where it is due.
  void refresh();

  /// Asks for the journal to be on the disk and ends the line of progress: the process is about to end.
  void close();

 private:
  void show(std::size_t cell, const std::string& line, std::optional<double> seconds);

  const MapDirectory& directory_;
  batch::Journal journal_;
  batch::LineLog partial_;
  batch::Progress progress_;
  std::size_t finished_ = 0;
};

/// Message of `program` after a signal: how many cells are finished, `finished` of them by this run.
std::string interrupted_map(std::string_view program, const MapDirectory& directory, std::size_t finished);

/// How the cells of a map are computed.
struct ComputeOptions {
  int threads = 0;                                            ///< 0: as many as the machine has cores
  const std::atomic<bool>* stop = nullptr;                    ///< once it is true, no further cell begins
  batch::ProgressMode progress = batch::ProgressMode::never;  ///< progress on stderr
  std::string program = "rubsweep";                           ///< named in locks and messages
};

/// Computes the cells that a directory misses and writes each one down as it is finished. `run` works in the
/// calling thread and in threads of its own; meanwhile one other thread may call `refresh` and `give_up`.
class MissingCells {
 public:
  /// All three must outlive it. Opens journal and partial map; throws IoError.
  MissingCells(const ComputeOptions& options, const sweep::Study& study, MapDirectory& directory);

  /// False when it was stopped before all were finished. Throws IoError.
  bool run();

  /// Redraws the progress, and asks for the journal to be on the disk where that is due.
  void refresh();

  /// Cells that still run are not waited for: nothing of them gets into the journal any more, and the
  /// directory is free for others. False, and nothing done, where no cell is left to give up.
  bool give_up();

  /// After a run that was stopped or given up: ends the progress, and returns a message of how many cells are
  /// finished.
  std::string interrupted();

  /// Cells that a refined map wants of other shards, none of which was at work when this one had no more to
  /// do.
  std::size_t left_to_others() const { return left_to_others_; }

  /// Cost of a refined map that is complete; empty for any other.
  const std::string& description() const { return description_; }

 private:
  bool all_finished() const { return log_.finished() == directory_.missing().size(); }
  bool run_refined();
  void run_pilots(std::vector<std::size_t>& cells, std::size_t pilots_wanted, const std::string& hint);
  void run_cells(std::span<const std::size_t> cells);
  void write_down(std::size_t cell, const sweep::Row& row, double seconds);
  bool say_progress(const std::string& text);

  const int threads_;
  const sweep::Study& study_;
  MapDirectory& directory_;
  const std::string program_;
  const std::atomic<bool> never_ = false;
  const std::atomic<bool>& stop_;
  std::mutex mutex_;  ///< guards all that follows
  CellLog log_;
  bool complete_ = false;  ///< a refined map wants no more cells
  bool given_up_ = false;
  std::size_t left_to_others_ = 0;
  std::string description_;
};

/// Computes the map of a configuration in `directory`, or goes on with what an earlier call left there, and
/// returns the summary of the whole map.csv, which stands there with the configuration; empty where it was
/// stopped: a later call computes the rest. Throws LockedError where another process is at work there,
/// ConfigError where the cells there belong to another configuration, IoError.
std::optional<report::MapSummary> compute(const config::RunConfig& config,
                                          const std::filesystem::path& directory,
                                          const ComputeOptions& options = {});

}  // namespace rubsweep::map
