#pragma once

#include <cstddef>
#include <vector>

#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::sweep {

/// Processes and threads that compute a sweep.
struct Workers {
  int threads = 1;  ///< threads of each process
  int ranks = 0;    ///< MPI processes that share the work; 0: one process without MPI
};

/// Memory and disk space of a sweep, rounded up.
struct Footprint {
  /// Memory of each process. It holds, for each thread, the last two windows of its cell and its cached flows
  /// (`integrate/exact/mode_cache`), for a rotor kit those of one machine per speed.
  std::size_t memory_bytes = 0;
  std::size_t disk_bytes = 0;  ///< disk space in bytes: journals, map.partial.csv and in the end map.csv
};

/// Footprint of all cells of a study. The constants were measured. Memory: 72 bytes a window sample for a
/// single wall, 175 where a comb is searched for in an annular stop; 24 bytes a cell; 9 MB for MPI on one
/// machine, more over networks. Disk: 340 bytes a row, three times. Flows are counted as if every thread
/// needed all speeds and every contact mode, up to the limit of the cache. Throws ConfigError where the
/// machine cannot be built.
Footprint footprint(const Study& study, const Workers& workers);
/// Footprint for a machine that is already built; to build a rotor kit takes 70 ms.
Footprint footprint(const Study& study, const scene::PreparedMachine& prepared, const Workers& workers);

/// Upper bound of the memory of any footprint of this study; needs no built machine.
std::size_t most_memory_bytes(const Study& study, const Workers& workers);

/// Removes `count` evenly spread cells from `cells` and returns them. They are run first, to predict the time
/// of the others.
std::vector<std::size_t> take_pilot_cells(std::vector<std::size_t>& cells, std::size_t count);

}  // namespace rubsweep::sweep
