#include "rubsweep/core/numerics/assignment.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace rubsweep::numerics {
namespace {

double total(const Eigen::MatrixXd& cost, const std::vector<Eigen::Index>& columns) {
  double sum = 0;
  for (std::size_t i = 0; i < columns.size(); ++i) sum += cost(static_cast<Eigen::Index>(i), columns[i]);
  return sum;
}

TEST(AssignmentCheapest, IsTheCheapestOfAllPermutations) {
  std::mt19937_64 engine(1);
  std::uniform_real_distribution<double> number(0, 1);
  for (int trial = 0; trial < 200; ++trial) {
    const Eigen::Index size = 1 + trial % 6;
    const Eigen::MatrixXd cost = Eigen::MatrixXd::NullaryExpr(size, size, [&] { return number(engine); });
    std::vector<Eigen::Index> columns(static_cast<std::size_t>(size));
    std::iota(columns.begin(), columns.end(), Eigen::Index{0});
    double least = total(cost, columns);
    while (std::next_permutation(columns.begin(), columns.end()))
      least = std::min(least, total(cost, columns));
    auto found = cheapest_assignment(cost);
    EXPECT_NEAR(total(cost, found), least, 1e-14);
    std::sort(found.begin(), found.end());
    std::sort(columns.begin(), columns.end());
    EXPECT_EQ(found, columns);
  }
}

}  // namespace
}  // namespace rubsweep::numerics
