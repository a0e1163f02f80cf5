#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "rubsweep/analysis/page/map_table.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::page {

/// A part of a grid of cells: every `stride`-th value of each axis, beginning with its stride / 2-th.
struct ThinnedGrid {
  std::size_t speeds = 0, unbalances = 0;  ///< of the whole grid
  std::size_t speed_stride = 1, unbalance_stride = 1;

  bool whole() const { return speed_stride == 1 && unbalance_stride == 1; }

  /// The cells that stay, ascending; cell = i_unbalance x speeds + i_speed.
  std::vector<std::size_t> cells() const;
};

/// The densest such part of no more than `most` cells (>= 1) whose strides are about alike.
ThinnedGrid thinned_grid(std::size_t speeds, std::size_t unbalances, std::size_t most);

/// Cells whose motions are compressed together.
inline constexpr std::size_t cells_per_block = 32;

/// The settled motions of a map.
struct Orbits {
  std::vector<std::size_t> cells;   ///< that were recorded, ascending
  std::size_t recorded = 0;         ///< of them, those that have a motion
  std::vector<std::string> blocks;  ///< block b: cells[32 b] ... by encode_orbit, compressed
};

/// Records `cells`, whose verdicts are the rows of `map` of these numbers, on `threads` threads (0: all
/// processors). Depends on neither their number nor their order. `on_cell` follows each cell, one call at a
/// time. Empty when `stop` became true before all were recorded. Throws as batch::parallel_run does.
std::optional<Orbits> record_orbits(const sweep::Study& study, const MapTable& map,
                                    std::vector<std::size_t> cells, int threads,
                                    const std::function<void()>& on_cell, const std::atomic<bool>& stop);

/// A wall as it is drawn with an orbit, in metres from the rotor's rest position.
struct Wall {
  bool around = false;                   ///< around the rotor, else flat
  std::array<double, 2> normal{0, 1};    ///< flat wall: from the rest position towards it
  std::array<double, 2> centre_m{0, 0};  ///< wall around the rotor
  double clearance_m = 0;
  bool at_orbit = true;  ///< it stands at the point of the shaft whose orbit is drawn

  friend bool operator==(const Wall&, const Wall&) = default;
};

/// The walls of all cells. Only keys move them, speed and unbalance do not.
struct Walls {
  std::vector<std::vector<Wall>> lists;  ///< each once
  /// Which of the lists holds for each combination of values of the axes over keys, in the order of the
  /// cells; 0 for the only one where there are no such axes.
  std::vector<std::size_t> list_of_keys;
};

/// Walls of the study; where keys have values that are not allowed there are none, as there is no motion.
Walls walls_of(const sweep::Study& study);

}  // namespace rubsweep::page
