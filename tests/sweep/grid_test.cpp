#include "rubsweep/sweep/grid.hpp"

#include <gtest/gtest.h>

namespace rubsweep::sweep {
namespace {

TEST(Grid, SpeedIsFastest) {
  const Grid grid{{50, 60, 70}, UnbalanceMeasure::whirl_ratio, {0.2, 0.6}};
  EXPECT_EQ(cell_count(grid), 6u);
  const scene::Place place = place_of(grid, 4);
  EXPECT_EQ(place.speed_hz, 60);
  EXPECT_EQ(std::get<scene::WhirlRatio>(place.unbalance).value, 0.6);
}

TEST(Grid, TheMeasureSaysWhatAValueIs) {
  const Grid grid{{50}, UnbalanceMeasure::eccentricity_m, {1e-5, 2e-5}};
  EXPECT_EQ(std::get<scene::Eccentricity>(place_of(grid, 1).unbalance).value_m, 2e-5);
  EXPECT_EQ(to_string(UnbalanceMeasure::whirl_ratio), "whirl_ratio");
  EXPECT_EQ(to_string(UnbalanceMeasure::eccentricity_m), "eccentricity_m");
}

TEST(Grid, OneCellOfAGridIsAGridOfItsOwn) {
  for (const auto measure : {UnbalanceMeasure::whirl_ratio, UnbalanceMeasure::eccentricity_m}) {
    const Grid one = grid_of(place_of({{50, 60}, measure, {0.2, 0.6}}, 3));
    EXPECT_EQ(one.speed_hz, std::vector<double>{60});
    EXPECT_EQ(one.measure, measure);
    EXPECT_EQ(one.unbalance, std::vector<double>{0.6});
  }
}

}  // namespace
}  // namespace rubsweep::sweep
