#include "rubsweep/core/numerics/pair_series.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace rubsweep::numerics {
namespace {

/// Oscillators without damping, lightly, critically and otherwise damped; a spiral; two real eigenvalues.
const std::vector<Pair> every_kind{{0, 5, -5, 0},   {0, 5, -5, -1},  {0, 5, -5, -10},
                                   {0, 1, -25, -2}, {-1, 4, -4, -1}, {-1, 0, 0, -5}};

TEST(PairSeries, SumsToTheFlow) {
  constexpr double fastest = 10;
  const PairSeries series = pair_series(every_kind, fastest);
  for (std::size_t j = 0; j < every_kind.size(); ++j) {
    for (const double x : {-1.0, 0.03, 0.5, 1.0}) {
      double unit = 0, generator = 0;
      for (Eigen::Index k = most_series_terms; k-- > 0;) {
        unit = unit * x + series.unit(static_cast<Eigen::Index>(j), k);
        generator = generator * x + series.generator(static_cast<Eigen::Index>(j), k);
      }
      const Pair& g = every_kind[j];
      const Pair flow = pair_flow(g, x / fastest);
      EXPECT_NEAR(unit + generator * g.uu, flow.uu, 1e-14) << j << ' ' << x;
      EXPECT_NEAR(generator * g.uv, flow.uv, 1e-14) << j << ' ' << x;
      EXPECT_NEAR(generator * g.vu, flow.vu, 1e-14) << j << ' ' << x;
      EXPECT_NEAR(unit + generator * g.vv, flow.vv, 1e-14) << j << ' ' << x;
    }
  }
}

TEST(PairSeries, StartsAtTheUnitMatrix) {
  const PairSeries series = pair_series(every_kind, 10);
  EXPECT_TRUE((series.unit.col(0) == 1).all());
  EXPECT_TRUE((series.generator.col(0) == 0).all());
  EXPECT_TRUE((series.generator.col(1) == 0.1).all());
}

}  // namespace
}  // namespace rubsweep::numerics
