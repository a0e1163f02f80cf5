#pragma once

#include <atomic>
#include <filesystem>
#include <optional>
#include <string>

#include "rubsweep/maps/batch/progress.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/report/map_summary.hpp"

namespace rubsweep::map {

/// How the cells of a map are computed.
struct ComputeOptions {
  int threads = 0;                                            ///< 0: as many as the machine has cores
  const std::atomic<bool>* stop = nullptr;                    ///< once it is true, no further cell begins
  batch::ProgressMode progress = batch::ProgressMode::never;  ///< progress on stderr
  std::string program = "rubsweep";                           ///< named in locks and messages
};

/// Computes the map of a configuration in `directory`, or goes on with what an earlier call left there, and
/// returns the summary of the whole map.csv, which stands there with the configuration; empty where it was
/// stopped: a later call computes the rest. Throws LockedError where another process is at work there,
/// ConfigError where the cells there belong to another configuration, IoError.
std::optional<report::MapSummary> compute(const config::RunConfig& config,
                                          const std::filesystem::path& directory,
                                          const ComputeOptions& options = {});

}  // namespace rubsweep::map
