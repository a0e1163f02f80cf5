#pragma once

/// \file
/// A map in a directory, as the program `rubsweep` makes it: map::compute runs the cells that are missing
/// there on all processors, writes each one down as it is finished, and at the end the whole map.csv. What
/// was stopped or killed goes on where it was. The numbers do not depend on the number of threads.
///
/// Options: `threads` (0: all), `stop` (a flag that ends the work, with what is finished kept), `progress`
/// on stderr. Throws LockedError where another process is at work there, ConfigError where the cells there
/// belong to another configuration, IoError. Returns the summary of the whole map; empty where it was
/// stopped.
///
/// ```cpp
/// using namespace rubsweep;
/// const config::RunConfig config = config::read_run_config(
///     "configs/minimal.yaml",
///     {"sweep.speed_hz={values: [60, 70]}", "sweep.whirl_ratio={values: [0.1, 0.2]}"});
/// const auto directory = std::filesystem::temp_directory_path() / "rubsweep_example_map";
/// const auto summary = map::compute(config, directory, {.threads = 1});
/// if (summary) std::printf("%s%s\n", summary->text().c_str(), (directory / "map.csv").c_str());
/// std::filesystem::remove_all(directory);
/// ```

#include "rubsweep/maps/map/missing_cells.hpp"
