#include "rubsweep/basin/basin_entropy.hpp"

#include <cmath>
#include <map>

namespace rubsweep::basin {
namespace {

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
