#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace rubsweep::basin {

/// Attractors of a rectangular grid of initial conditions: a number for each attractor.
struct LabelGrid {
  std::size_t columns = 0, rows = 0;
  std::vector<int> labels;  ///< columns * rows, row by row

  int at(std::size_t column, std::size_t row) const { return labels[row * columns + column]; }
};

/// How mixed basins are (Daza, Wagemakers, Georgeot, Guery-Odelin and Sanjuan 2016): the mean over boxes of
/// the entropy sum p log(1 / p), p being the shares of the labels in a box.
struct BasinEntropy {
  double all = 0;       ///< mean over all boxes
  double boundary = 0;  ///< mean over boxes with more than one label; above log 2 the boundary is fractal
};

/// Entropy from boxes of `side` x `side` points (side >= 1), side by side, without remainders at far ends.
BasinEntropy basin_entropy(const LabelGrid& grid, std::size_t side);

/// Growth of the share f of uncertain boxes, those that hold more than one label, with their side e: f ~
/// e^exponent. The dimension of the boundary is that of the plane less this (McDonald, Grebogi, Ott and Yorke
/// 1985). 1: a line; near 0: a better knowledge of the start hardly helps.
struct UncertaintyExponent {
  double value = 0;
  double standard_error = 0;  ///< error of the straight line through log f over log e
};

/// Exponent from boxes of 2, 3, 5, 9, ... points a side (1, 2, 4, 8, ... steps), up to a quarter of the
/// shorter side. Empty where fewer than three sizes have an uncertain box and a certain one.
std::optional<UncertaintyExponent> uncertainty_exponent(const LabelGrid& grid);

}  // namespace rubsweep::basin
