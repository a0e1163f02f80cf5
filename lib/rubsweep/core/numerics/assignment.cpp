#include "rubsweep/core/numerics/assignment.hpp"

#include <limits>

namespace rubsweep::numerics {
namespace {

using Eigen::Index;
constexpr Index none = -1;

/// A matching that grows by one row at a time along the cheapest augmenting path. The sum of a row's price
/// and a column's price never exceeds the cost of their entry, and equals the cost where row and column are
/// matched.
class Matching {
 public:
  explicit Matching(const Eigen::MatrixXd& cost)
      : cost_(cost),
        start_(cost.rows()),
        row_price_(Eigen::VectorXd::Zero(cost.rows())),
        column_price_(Eigen::VectorXd::Zero(cost.rows() + 1)),
        row_of_(static_cast<std::size_t>(cost.rows()) + 1, none) {}

  void add(Index row) {
    Search search(start_);
    row_at(start_) = row;
    Index column = start_;
    while (row_at(column) != none) column = cheapest_next(column, search);
    while (column != start_) {
      const Index previous = search.before[static_cast<std::size_t>(column)];
      row_at(column) = row_at(previous);
      column = previous;
    }
    row_at(start_) = none;
  }

  std::vector<Index> column_of_rows() {
    std::vector<Index> column_of(static_cast<std::size_t>(start_));
    for (Index column = 0; column < start_; ++column)
      column_of[static_cast<std::size_t>(row_at(column))] = column;
    return column_of;
  }

 private:
  /// Tree of paths from one row; `before` holds the column from which each column was reached.
  struct Search {
    explicit Search(Index size)
        : slack(Eigen::VectorXd::Constant(size, std::numeric_limits<double>::infinity())),
          visited(Eigen::Array<bool, Eigen::Dynamic, 1>::Constant(size + 1, false)),
          before(static_cast<std::size_t>(size), size) {}
    Eigen::VectorXd slack;
    Eigen::Array<bool, Eigen::Dynamic, 1> visited;
    std::vector<Index> before;
  };

  Index& row_at(Index column) { return row_of_[static_cast<std::size_t>(column)]; }

  /// Visits `column` and returns the unvisited one that is cheapest to reach.
  Index cheapest_next(Index column, Search& search) {
    search.visited(column) = true;
    double least = std::numeric_limits<double>::infinity();
    Index next = none;
    for (Index k = 0; k < start_; ++k) {
      if (search.visited(k)) continue;
      const double reduced = cost_(row_at(column), k) - row_price_(row_at(column)) - column_price_(k);
      if (reduced < search.slack(k)) {
        search.slack(k) = reduced;
        search.before[static_cast<std::size_t>(k)] = column;
      }
      if (search.slack(k) < least) {
        least = search.slack(k);
        next = k;
      }
    }
    raise_prices(least, search);
    return next;
  }

  void raise_prices(double by, Search& search) {
    for (Index k = 0; k <= start_; ++k) {
      if (search.visited(k)) {
        row_price_(row_at(k)) += by;
        column_price_(k) -= by;
      } else if (k < start_) {
        search.slack(k) -= by;
      }
    }
  }

  const Eigen::MatrixXd& cost_;
  Index start_;  ///< number of rows; also the index of the artificial column where every path starts
  Eigen::VectorXd row_price_, column_price_;
  std::vector<Index> row_of_;  ///< row matched with each column, or `none`
};

}  // namespace

std::vector<Index> cheapest_assignment(const Eigen::MatrixXd& cost) {
  Matching matching(cost);
  for (Index row = 0; row < cost.rows(); ++row) matching.add(row);
  return matching.column_of_rows();
}

}  // namespace rubsweep::numerics
