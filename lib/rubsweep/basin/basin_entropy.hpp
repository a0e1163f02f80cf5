#pragma once

#include <cstddef>

#include "rubsweep/basin/label_grid.hpp"

namespace rubsweep::basin {

/// How mixed basins are (Daza, Wagemakers, Georgeot, Guery-Odelin and Sanjuan 2016): the mean over boxes of
/// the entropy sum p log(1 / p), p being the shares of the labels in a box.
struct BasinEntropy {
  double all = 0;       ///< over all boxes
  double boundary = 0;  ///< over those with more than one label; above log 2 the boundary is fractal
};

/// Entropy from boxes of `side` x `side` points (side >= 1), side by side, without remainders at far ends.
BasinEntropy basin_entropy(const LabelGrid& grid, std::size_t side);

}  // namespace rubsweep::basin
