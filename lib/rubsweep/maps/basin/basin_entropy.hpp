#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace rubsweep::basin {

/// Attractor of each point on a rectangular grid of initial conditions; equal numbers mean the same
/// attractor.
struct LabelGrid {
  std::size_t columns = 0, rows = 0;
  std::vector<int> labels;  ///< labels of columns * rows points, row by row

  int at(std::size_t column, std::size_t row) const { return labels[row * columns + column]; }
};

/// Basin entropy, a measure of how mixed basins are (Daza, Wagemakers, Georgeot, Guery-Odelin and Sanjuan
/// 2016). It is the mean over boxes of sum p log(1 / p), where p is the share of a label in the box.
struct BasinEntropy {
  double all = 0;       ///< mean over all boxes
  double boundary = 0;  ///< mean over boxes with more than one label; above log 2 the boundary is fractal
};

/// Entropy from adjoining boxes of `side` x `side` points (side >= 1). Points at the far ends that do not
/// fill a box are left out.
BasinEntropy basin_entropy(const LabelGrid& grid, std::size_t side);

/// Exponent a in f ~ e^a, where f is the share of boxes of side e that hold more than one label (McDonald,
/// Grebogi, Ott and Yorke 1985). The dimension of the boundary is the dimension of the plane minus a. At a =
/// 1 the boundary is a line. Near 0, a more precise initial condition makes the outcome hardly more certain.
struct UncertaintyExponent {
  double value = 0;
  double standard_error = 0;  ///< standard error of the slope of log f over log e
};

/// Exponent from boxes of 2, 3, 5, 9, ... points a side (1, 2, 4, 8, ... steps), up to a quarter of the
/// shorter side of the grid. Empty where fewer than three sizes have both boxes with one label and boxes with
/// several labels.
std::optional<UncertaintyExponent> uncertainty_exponent(const LabelGrid& grid);

}  // namespace rubsweep::basin
