#pragma once

#include <atomic>
#include <filesystem>
#include <optional>
#include <string>

#include "rubsweep/maps/batch/progress.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/report/map_summary.hpp"

namespace rubsweep::map {

/// Options for computing the cells of a map.
struct ComputeOptions {
  int threads = 0;                                            ///< 0: as many as the machine has cores
  const std::atomic<bool>* stop = nullptr;                    ///< once it is true, no further cell begins
  batch::ProgressMode progress = batch::ProgressMode::never;  ///< progress on stderr
  std::string program = "rubsweep";                           ///< name in locks and messages
};

/// Computes the map of a configuration in `directory`, or continues what an earlier call left there. Writes
/// map.csv and the configuration, and returns the summary of the whole map. Empty where the run was stopped;
/// a later call then computes the rest. Throws LockedError where another process is at work there,
/// ConfigError where the cells there belong to another configuration, and IoError.
std::optional<report::MapSummary> compute(const config::RunConfig& config,
                                          const std::filesystem::path& directory,
                                          const ComputeOptions& options = {});

}  // namespace rubsweep::map
