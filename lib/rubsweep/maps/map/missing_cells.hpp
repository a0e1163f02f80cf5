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

#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/maps/batch/journal.hpp"
#include "rubsweep/maps/batch/progress.hpp"
#include "rubsweep/maps/batch/whole_file.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/map/map_directory.hpp"
#include "rubsweep/maps/report/map_summary.hpp"
#include "rubsweep/maps/sweep/row.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::map {

/// Writes finished cells to the journal of this process, to the partial map and to the progress line on
/// stderr. Only one thread at a time may use it.
class CellLog {
 public:
  /// Opens both files. `directory` must outlive this log. Throws IoError.
  CellLog(const MapDirectory& directory, batch::ProgressMode mode);

  /// Writes a cell with its line of the map. `seconds` is the time that it took on its thread. Throws
  /// IoError.
  void add(std::size_t cell, const std::string& line, std::optional<double> seconds = {});

  /// Counts and shows a cell that another process wrote to its own journal.
  void add_of_other_process(std::size_t cell, const std::string& line);

  /// Number of added cells.
  std::size_t finished() const { return finished_; }

  batch::Progress& progress() { return progress_; }

  /// Redraws the progress line and syncs the journal to the disk, each only when due.
  void refresh();

  /// Syncs the journal to the disk and ends the progress line, before the process ends.
  void close();

 private:
  void show(std::size_t cell, const std::string& line, std::optional<double> seconds);

  const MapDirectory& directory_;
  batch::Journal journal_;
  batch::LineLog partial_;
  batch::Progress progress_;
  std::size_t finished_ = 0;
};

/// Message of `program` after a signal: number of finished cells, of which this run computed `finished`.
std::string interrupted_map(std::string_view program, const MapDirectory& directory, std::size_t finished);

/// Options for computing the cells of a map.
struct ComputeOptions {
  int threads = 0;                                            ///< 0: as many as the machine has cores
  const std::atomic<bool>* stop = nullptr;                    ///< once it is true, no further cell begins
  batch::ProgressMode progress = batch::ProgressMode::never;  ///< progress on stderr
  std::string program = "rubsweep";                           ///< name in locks and messages
  std::optional<scene::PreparedMachine> prepared{};  ///< machine of the study; empty: prepared when needed
};

/// Computes the missing cells of a directory and writes each as it is finished. `run` uses the calling thread
/// and threads of its own. One other thread may call `refresh` and `give_up` during that time.
class MissingCells {
 public:
  /// Opens journal and partial map. All arguments must outlive this object. Throws IoError.
  MissingCells(const ComputeOptions& options, const sweep::Study& study, MapDirectory& directory);

  /// Returns false where `stop` ended the run before all cells were finished. Throws IoError.
  bool run();

  /// Redraws the progress line and syncs the journal to the disk, each only when due.
  void refresh();

  /// Gives up cells that still run: they are no longer written to the journal, and the directory is unlocked.
  /// Where no cell remains, returns false and does nothing.
  bool give_up();

  /// Ends the progress line after a run that was stopped or given up. Returns a message with the number of
  /// finished cells.
  std::string interrupted();

  /// Number of cells that a refined map still needs but that belong to other shards, none of which was at
  /// work when this shard ended.
  std::size_t left_to_others() const { return left_to_others_; }

  /// Text on the cost of a complete refined map; empty for any other map.
  const std::string& description() const { return description_; }

 private:
  const scene::PreparedMachine& prepared();
  bool all_finished() const { return log_.finished() == directory_.missing().size(); }
  bool run_refined();
  void run_pilots(std::vector<std::size_t>& cells, std::size_t pilots_wanted, const std::string& hint);
  void run_cells(std::span<const std::size_t> cells);
  void write_down(std::size_t cell, const sweep::Row& row, double seconds);
  bool say_progress(const std::string& text);

  const int threads_;
  const sweep::Study& study_;
  std::optional<scene::PreparedMachine> prepared_;
  MapDirectory& directory_;
  const std::string program_;
  const std::atomic<bool> never_ = false;
  const std::atomic<bool>& stop_;
  std::mutex mutex_;  ///< guards all members below
  CellLog log_;
  bool complete_ = false;  ///< true: a refined map needs no more cells
  bool given_up_ = false;
  std::size_t left_to_others_ = 0;
  std::string description_;
};

/// Computes the map of a configuration in `directory`, or continues what an earlier call left there. Writes
/// map.csv and the configuration, and returns the summary of the whole map. Empty where the run was stopped;
/// a later call then computes the rest. Throws LockedError where another process is at work there,
/// ConfigError where the cells there belong to another configuration, and IoError.
std::optional<report::MapSummary> compute(const config::RunConfig& config,
                                          const std::filesystem::path& directory,
                                          const ComputeOptions& options = {});

}  // namespace rubsweep::map
