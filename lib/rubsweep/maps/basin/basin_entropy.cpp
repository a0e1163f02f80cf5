#include "rubsweep/maps/basin/basin_entropy.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace rubsweep::basin {
namespace {

bool uncertain(const LabelGrid& grid, std::size_t column, std::size_t row, std::size_t steps) {
  const int label = grid.at(column, row);
  for (std::size_t j = row; j <= row + steps; ++j) {
    for (std::size_t i = column; i <= column + steps; ++i) {
      if (grid.at(i, j) != label) return true;
    }
  }
  return false;
}

/// Share of boxes with more than one label. A box has `steps` grid steps a side, and boxes adjoin each other.
double uncertain_share(const LabelGrid& grid, std::size_t steps) {
  std::size_t boxes = 0, found = 0;
  for (std::size_t row = 0; row + steps < grid.rows; row += steps) {
    for (std::size_t column = 0; column + steps < grid.columns; column += steps) {
      ++boxes;
      if (uncertain(grid, column, row, steps)) ++found;
    }
  }
  return static_cast<double>(found) / static_cast<double>(boxes);
}

double entropy_of(const LabelGrid& grid, std::size_t column, std::size_t row, std::size_t side) {
  std::map<int, double> counts;
  for (std::size_t j = row; j < row + side; ++j) {
    for (std::size_t i = column; i < column + side; ++i) ++counts[grid.at(i, j)];
  }
  double entropy = 0;
  const auto points = static_cast<double>(side * side);
  for (const auto& [label, count] : counts) entropy += count / points * std::log(points / count);
  return entropy;
}

}  // namespace

std::optional<UncertaintyExponent> uncertainty_exponent(const LabelGrid& grid) {
  std::vector<double> x, y;
  for (std::size_t steps = 1; 4 * steps <= std::min(grid.columns, grid.rows); steps *= 2) {
    const double share = uncertain_share(grid, steps);
    if (share <= 0 || share >= 1) continue;
    x.push_back(std::log(static_cast<double>(steps)));
    y.push_back(std::log(share));
  }
  const auto n = static_cast<double>(x.size());
  if (x.size() < 3) return std::nullopt;
  double mean_x = 0, mean_y = 0, xx = 0, xy = 0, residual = 0;
  for (std::size_t i = 0; i < x.size(); ++i) mean_x += x[i] / n, mean_y += y[i] / n;
  for (std::size_t i = 0; i < x.size(); ++i)
    xx += std::pow(x[i] - mean_x, 2), xy += (x[i] - mean_x) * (y[i] - mean_y);
  const double slope = xy / xx;
  for (std::size_t i = 0; i < x.size(); ++i) residual += std::pow(y[i] - mean_y - slope * (x[i] - mean_x), 2);
  return UncertaintyExponent{slope, std::sqrt(residual / (n - 2) / xx)};
}

BasinEntropy basin_entropy(const LabelGrid& grid, std::size_t side) {
  double sum = 0;
  std::size_t boxes = 0, mixed = 0;
  for (std::size_t row = 0; row + side <= grid.rows; row += side) {
    for (std::size_t column = 0; column + side <= grid.columns; column += side) {
      const double entropy = entropy_of(grid, column, row, side);
      sum += entropy;
      ++boxes;
      if (entropy > 0) ++mixed;
    }
  }
  return {boxes > 0 ? sum / static_cast<double>(boxes) : 0, mixed > 0 ? sum / static_cast<double>(mixed) : 0};
}

}  // namespace rubsweep::basin
