#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "rubsweep/maps/batch/progress.hpp"
#include "rubsweep/maps/map/map_directory.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::apps {

/// How a program goes about a sweep.
struct SweepRun {
  std::string program;  ///< who says how it goes
  int threads = 0;
  batch::ProgressMode progress = batch::ProgressMode::automatic;
  bool quiet = false;
};

/// Prints how many cells were finished before, and computes the others. Empty when a signal came, else
/// map::MissingCells::left_to_others. Cells that still run half a second after a signal are given up, and the
/// process ends without them.
std::optional<std::size_t> compute_missing_cells(const SweepRun& how, const sweep::Study& study,
                                                 map::MapDirectory& directory);

}  // namespace rubsweep::apps
