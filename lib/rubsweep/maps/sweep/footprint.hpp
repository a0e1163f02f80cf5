#pragma once

#include <cstddef>
#include <vector>

#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::sweep {

/// Who computes a sweep.
struct Workers {
  int threads = 1;  ///< threads of each process
  int ranks = 0;    ///< processes of MPI that share the work; 0: one process without MPI
};

/// Memory and disk space of a sweep, rounded up.
struct Footprint {
  /// Memory of each process: the last two windows of the cell of each thread, and the flows that each thread
  /// keeps of machines it has met (`integrate/exact/mode_cache`), one per speed of a rotor kit.
  std::size_t memory_bytes = 0;
  std::size_t disk_bytes = 0;  ///< while it runs: journals, map.partial.csv and in the end map.csv
};

/// Footprint of all cells of a study. Measured: 72 bytes of memory a window sample for a single wall, 175
/// where an annular stop is searched for a comb; 24 bytes a cell; 9 MB for MPI among ranks of one machine, of
/// which networks take more; 340 bytes of disk a row, three times. Flows are counted as if every thread met
/// all speeds, and every contact mode there, up to the limit of the cache. Throws ConfigError where the
/// machine cannot be built.
Footprint footprint(const Study& study, const Workers& workers);
/// The same where the machine is built already, which takes a rotor kit 70 ms.
Footprint footprint(const Study& study, const scene::PreparedMachine& prepared, const Workers& workers);

/// No footprint's memory is more than this, which is known without building the machine.
std::size_t most_memory_bytes(const Study& study, const Workers& workers);

/// `count` cells spread evenly over `cells`, which lose them: run first, they tell how long the others will
/// take.
std::vector<std::size_t> take_pilot_cells(std::vector<std::size_t>& cells, std::size_t count);

}  // namespace rubsweep::sweep
