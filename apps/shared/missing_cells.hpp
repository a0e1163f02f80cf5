#pragma once

#include <atomic>
#include <cstddef>
#include <mutex>
#include <optional>
#include <span>
#include <string>

#include "rubsweep/maps/batch/progress_mode.hpp"
#include "rubsweep/maps/map/cell_log.hpp"
#include "rubsweep/maps/map/map_directory.hpp"
#include "rubsweep/maps/sweep/row.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::apps {

/// How a program goes about a sweep.
struct SweepRun {
  std::string program;  ///< who says how it goes
  int threads = 0;
  batch::ProgressMode progress = batch::ProgressMode::automatic;
  bool quiet = false;
};

/// Computes the cells that a directory misses and writes each one down as it is finished.
class MissingCells {
 public:
  /// All three must outlive it. Opens journal and partial map; throws IoError.
  MissingCells(const SweepRun& how, const sweep::Study& study, map::MapDirectory& directory);

  /// False when a signal came before all were finished. Cells that still run half a second after it are given
  /// up: nothing of them is in the journal, and the process ends without them.
  bool run();

  /// Cells that a refined map wants of other shards, none of which was at work when this one had no more to
  /// do.
  std::size_t left_to_others() const { return left_to_others_; }

 private:
  bool all_finished() const { return log_.finished() == directory_.missing().size(); }
  bool run_refined();
  void run_cells(std::span<const std::size_t> cells);
  void write_down(std::size_t cell, const sweep::Row& row, double seconds);
  bool say_progress(const std::string& text);
  void refresh();
  void leave();
  void say_interrupted();

  const SweepRun& how_;
  const sweep::Study& study_;
  map::MapDirectory& directory_;
  const std::atomic<bool>& stop_;
  std::mutex mutex_;  ///< guards all that follows
  map::CellLog log_;
  bool complete_ = false;  ///< a refined map wants no more cells
  std::size_t left_to_others_ = 0;
};

/// Prints how many cells were finished before, and computes the others. Empty when a signal came, else
/// MissingCells::left_to_others.
std::optional<std::size_t> compute_missing_cells(const SweepRun& how, const sweep::Study& study,
                                                 map::MapDirectory& directory);

}  // namespace rubsweep::apps
