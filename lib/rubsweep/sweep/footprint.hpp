#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "rubsweep/sweep/study.hpp"

namespace rubsweep::sweep {

/// What a sweep takes besides time, rounded up.
struct Footprint {
  std::size_t memory_bytes =
      0;                       ///< of the process, most of it the last two windows of the cell of each thread
  std::size_t disk_bytes = 0;  ///< while it runs: journal, map.partial.csv and in the end map.csv
};

/// Of all cells of a study on so many threads (>= 1). Measured: 72 bytes of memory a window sample for a
/// single wall, 175 where a ring is searched for a comb; 24 bytes a cell; 340 bytes of disk a row, three
/// times.
Footprint footprint(const Study& study, int threads);

/// "1320 cells on 2 threads: up to 21 MB of memory, 1.4 MB of disk".
std::string describe(const Study& study, int threads);

/// `count` cells spread evenly over `cells`, which lose them: run first, they tell how long the others will
/// take.
std::vector<std::size_t> take_pilot_cells(std::vector<std::size_t>& cells, std::size_t count);

}  // namespace rubsweep::sweep
