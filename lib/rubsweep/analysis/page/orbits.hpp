#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rubsweep/analysis/page/map_table.hpp"
#include "rubsweep/analysis/page/settled_orbit.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::page {

/// Which of the equidistant samples of some signals are enough to draw all of them by straight lines: with
/// the samples at the places returned (ascending, the first and the last among them), linear interpolation
/// misses no sample of any signal by more than `tolerance`. `always` lists places that stay in any case,
/// ascending. All signals have the same length, two samples or more. The method is that of Ramer, Douglas
/// and Peucker, with distances along the axis of values.
std::vector<std::size_t> needed_samples(std::span<const std::vector<double>> signals, double tolerance,
                                        std::span<const std::size_t> always);

/// Levels from the smallest to the largest value of a signal.
inline constexpr int levels = 4095;

/// Straight lines between the samples that are kept miss none of the others by more than this, as a share of
/// the larger extent of the orbit in x and y.
inline constexpr double drawing_tolerance = 1.0 / 400;

/// Spectral lines are kept up to this order, and from this share of the largest line on.
inline constexpr double highest_order = 12, smallest_line = 1e-3;

/// Appends `values` as they are drawn: the smallest and the width of one level (two floats), then for each
/// value its level as the difference from the one before (modulo 65536, two bytes, byte plane by byte plane).
void append_levels(std::string& bytes, std::span<const double> values);

/// One settled motion as the page reads it, numbers with the lowest byte first:
///   u32 cell; u32 bytes that follow;
///   u32 first revolution; u16 turns; u16 steps per turn; u16 kept samples; u16 signals;
///   u16 x kept samples: steps since the sample before (byte planes);
///   for each signal its kept samples, as append_levels writes them, in metres;
///   u16 points of the section; their x, then their y, as append_levels writes them;
///   u16 turns of the spectrum; u16 lines; f32 largest amplitude in metres; i16 x lines: the line's place k,
///   at order k / turns; u16 x lines: amplitude in 65535ths of the largest.
/// The samples kept are those that a drawing needs (needed_samples), and those on either side of each change
/// between gap and contact.
std::string encode_orbit(std::size_t cell, const SettledOrbit& orbit);

/// A part of a grid of cells: every `stride`-th value of each axis, beginning with its stride / 2-th.
struct ThinnedGrid {
  std::size_t speeds = 0, unbalances = 0;  ///< numbers of values in the whole grid
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
  std::vector<std::size_t> cells;   ///< cells that were recorded, ascending
  std::size_t recorded = 0;         ///< number of recorded cells that have a motion
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
  bool at_orbit = true;  ///< true: the stop stands at the point of the shaft whose orbit is drawn

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
