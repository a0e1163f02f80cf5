#pragma once

#include <span>
#include <string>
#include <string_view>

#include "rubsweep/analysis/line/follow_line.hpp"

namespace rubsweep::apps {

/// Largest order of spectral lines in the tables of a line or of a run-up.
inline constexpr int largest_cascade_order = 8;

/// Tables of a line of cells, as texts. The column `pass` is kick, up or down. `value` is the parameter along
/// the line; its name contains its unit.
struct LineTables {
  std::string line_csv;         ///< comments, then pass, value and the columns of map.csv
  std::string bifurcation_csv;  ///< pass, value, speed_hz, class, order, point, then x_m, y_m and velocities
  std::string cascade_csv;  ///< pass, value, speed_hz, order, frequency_hz, amplitude_m: significant lines
};

/// Tables of `points`, which belong to `cells`, in the order given; `along` is the name of the parameter.
LineTables tables_of(std::span<const line::LinePoint> points, std::span<const line::LineCell> cells,
                     std::string_view along);

/// Summary for a terminal: the motions of each pass in the order in which they occur along the line.
std::string line_summary(std::span<const line::LinePoint> points, std::span<const line::LineCell> cells);

}  // namespace rubsweep::apps
