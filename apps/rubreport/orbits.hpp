#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "rubreport/map_table.hpp"
#include "rubsweep/analysis/page/settled_orbit.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::page {

/// Indices of the samples that suffice to draw some signals by straight lines, ascending, with the first and
/// the last sample. Straight lines between these samples miss no sample of any signal by more than
/// `tolerance`. `always`: indices that are kept in any case, ascending. All signals have the same length of
/// at least two samples. Method of Ramer, Douglas and Peucker, with distances measured along the axis of
/// values.
std::vector<std::size_t> needed_samples(std::span<const std::vector<double>> signals, double tolerance,
                                        std::span<const std::size_t> always);

inline constexpr int levels = 4095;  ///< Number of levels from the smallest to the largest value.

/// Largest error of straight lines between kept samples, as a share of the orbit's larger extent in x, y.
inline constexpr double drawing_tolerance = 1.0 / 400;

/// Highest order of the spectral lines that are kept, and smallest amplitude as a share of the largest line.
inline constexpr double highest_order = 12, smallest_line = 1e-3;

/// Appends `values` as levels. First come the smallest value and the width of one level, as two floats. Then
/// follows for each value the difference between its level and the level before, modulo 65536, in two bytes.
/// The differences are stored in byte planes.
void append_levels(std::string& bytes, std::span<const double> values);

/// Bytes of one settled motion for the page; numbers begin with their lowest byte:
///   u32 cell; u32 bytes that follow;
///   u32 first revolution; u16 turns; u16 steps per turn; u16 kept samples; u16 signals;
///   u16 x kept samples: steps since the sample before (byte planes);
///   for each signal its kept samples, as append_levels writes them, in metres;
///   u16 points of the section; their x, then their y, as append_levels writes them;
///   u16 turns of the spectrum; u16 lines; f32 largest amplitude in metres; i16 x lines: the line's place k,
///   at order k / turns; u16 x lines: amplitude in 65535ths of the largest.
/// The kept samples are those that needed_samples returns, and those on both sides of each change between gap
/// and contact.
std::string encode_orbit(std::size_t cell, const SettledOrbit& orbit);

/// Part of a grid of cells: every `stride`-th value of each axis, beginning with value number stride / 2.
struct ThinnedGrid {
  std::size_t speeds = 0, unbalances = 0;  ///< numbers of values in the whole grid
  std::size_t speed_stride = 1, unbalance_stride = 1;

  bool whole() const { return speed_stride == 1 && unbalance_stride == 1; }

  std::vector<std::size_t> cells() const;  ///< Cells of this part, ascending: i_unbalance x speeds + i_speed.
};

/// Densest part of a grid that has at most `most` cells (>= 1) and similar strides on both axes.
ThinnedGrid thinned_grid(std::size_t speeds, std::size_t unbalances, std::size_t most);

inline constexpr std::size_t cells_per_block = 32;  ///< Number of cells whose motions are compressed at once.

/// The settled motions of a map.
struct Orbits {
  std::vector<std::size_t> cells;   ///< cells that were recorded, ascending
  std::size_t recorded = 0;         ///< number of recorded cells that have a motion
  std::vector<std::string> blocks;  ///< block b: cells[32 b] ... by encode_orbit, compressed
};

/// Records the settled motions of `cells`, given by their row numbers in `map`, on `threads` threads (0: all
/// processors). The result does not depend on the number of threads. `on_cell` is called after each cell, one
/// call at a time. Empty if `stop` became true before the end. Throws as batch::parallel_run does.
std::optional<Orbits> record_orbits(const sweep::Study& study, const MapTable& map,
                                    std::vector<std::size_t> cells, int threads,
                                    const std::function<void()>& on_cell, const std::atomic<bool>& stop);

/// Wall as it is drawn with an orbit, in metres from the rotor's rest position.
struct Wall {
  bool around = false;                   ///< true: around the rotor; false: flat
  std::array<double, 2> normal{0, 1};    ///< flat wall: direction from the rest position towards it
  std::array<double, 2> centre_m{0, 0};  ///< centre of a wall around the rotor
  double clearance_m = 0;
  bool at_orbit = true;  ///< true: the stop is at the shaft point whose orbit is drawn

  friend bool operator==(const Wall&, const Wall&) = default;
};

/// Walls in all cells. They change with the values of keys, but not with speed and unbalance.
struct Walls {
  std::vector<std::vector<Wall>> lists;  ///< all lists of walls that occur, each once
  /// Index in `lists` for each combination of values of the axes over keys, in the order of the cells.
  /// Without such axes it has a single element, 0.
  std::vector<std::size_t> list_of_keys;
};

/// Walls of the study. The list is empty for forbidden values of keys; their cells have no motion, either.
Walls walls_of(const sweep::Study& study);

}  // namespace rubsweep::page
