#pragma once

/// \file
/// A map in a directory, as the program `rubsweep` makes it. map::compute runs the missing cells on all
/// processors, stores each cell as soon as it is finished, and writes map.csv at the end. A map that was
/// stopped or killed is continued by the next call. The numbers do not depend on the number of threads.
///
/// Options: `threads` (0: all processors), `stop` (a flag that ends the work and keeps the finished cells),
/// `progress` on stderr. Throws LockedError where another process works in the directory, ConfigError where
/// its cells belong to another configuration, and IoError. Returns the summary of the whole map, or an empty
/// value if it was stopped.
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
