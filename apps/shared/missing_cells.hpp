#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "rubsweep/maps/batch/progress.hpp"
#include "rubsweep/maps/map/map_directory.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::apps {

/// Options for the run of a sweep.
struct SweepRun {
  std::string program;  ///< program name in messages
  int threads = 0;
  batch::ProgressMode progress = batch::ProgressMode::automatic;
  bool quiet = false;
};

/// Prints how many cells were finished earlier, and computes the others. Empty if a signal came, otherwise
/// map::MissingCells::left_to_others. If cells still run half a second after a signal, the process ends
/// without them.
std::optional<std::size_t> compute_missing_cells(const SweepRun& how, const sweep::Study& study,
                                                 map::MapDirectory& directory);

}  // namespace rubsweep::apps
