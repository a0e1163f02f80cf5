#include "rubsweep/ring/assignment.hpp"

#include <limits>

namespace rubsweep::ring {

using Eigen::Index;

std::vector<Index> cheapest_assignment(const Eigen::MatrixXd& cost) {
  const Index size = cost.rows();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr Index none = -1;
  // Dual prices of rows and columns; column `size` is the start of every augmenting path.
  Eigen::VectorXd row_price = Eigen::VectorXd::Zero(size), column_price = Eigen::VectorXd::Zero(size + 1);
  std::vector<Index> row_of(static_cast<std::size_t>(size) + 1, none);
  const auto at = [&row_of](Index column) -> Index& { return row_of[static_cast<std::size_t>(column)]; };

  for (Index row = 0; row < size; ++row) {
    Eigen::VectorXd slack = Eigen::VectorXd::Constant(size, infinity);
    Eigen::Array<bool, Eigen::Dynamic, 1> visited =
        Eigen::Array<bool, Eigen::Dynamic, 1>::Constant(size + 1, false);
    std::vector<Index> before(static_cast<std::size_t>(size), size);
    Index column = size;
    at(size) = row;
    while (at(column) != none) {
      visited(column) = true;
      double least = infinity;
      Index next = none;
      for (Index k = 0; k < size; ++k) {
        if (visited(k)) continue;
        const double reduced = cost(at(column), k) - row_price(at(column)) - column_price(k);
        if (reduced < slack(k)) {
          slack(k) = reduced;
          before[static_cast<std::size_t>(k)] = column;
        }
        if (slack(k) < least) {
          least = slack(k);
          next = k;
        }
      }
      for (Index k = 0; k <= size; ++k) {
        if (visited(k)) {
          row_price(at(k)) += least;
          column_price(k) -= least;
        } else if (k < size) {
          slack(k) -= least;
        }
      }
      column = next;
    }
    while (column != size) {
      const Index previous = before[static_cast<std::size_t>(column)];
      at(column) = at(previous);
      column = previous;
    }
    at(size) = none;
  }
  std::vector<Index> column_of(static_cast<std::size_t>(size));
  for (Index column = 0; column < size; ++column) column_of[static_cast<std::size_t>(at(column))] = column;
  return column_of;
}

}  // namespace rubsweep::ring
