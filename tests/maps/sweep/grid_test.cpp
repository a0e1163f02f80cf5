#include "rubsweep/maps/sweep/grid.hpp"

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

TEST(Grid, AxesOverKeysAreSlowerThanUnbalance) {
  const Grid grid{{50, 60},
                  UnbalanceMeasure::whirl_ratio,
                  {0.2, 0.6, 0.7},
                  {{{"a", "b.c"}, {1, -2}, {10, 20}}, {{"d"}, {1}, {7, 8, 9}}}};
  ASSERT_EQ(cell_count(grid), 2u * 3 * 2 * 3);
  EXPECT_EQ(key_names(grid), (std::vector<std::string>{"a", "b.c", "d"}));
  const std::size_t cell = 1 + 2 * (2 + 3 * (1 + 2 * 2));
  EXPECT_EQ(place_of(grid, cell).speed_hz, 60);
  EXPECT_EQ(std::get<scene::WhirlRatio>(place_of(grid, cell).unbalance).value, 0.7);
  const auto values = key_values(grid, cell);
  ASSERT_EQ(values.size(), 3u);
  EXPECT_EQ(values[0].value, 20);
  EXPECT_EQ(values[1].key, "b.c");
  EXPECT_EQ(values[1].value, -40);
  EXPECT_EQ(values[2].value, 9);
}

TEST(Grid, SweptAxesHaveSeveralValues) {
  const Grid grid{
      {50}, UnbalanceMeasure::eccentricity_m, {1e-5, 2e-5}, {{{"a"}, {1}, {3}}, {{"b"}, {1}, {4, 5}}}};
  const auto swept = swept_axes(grid);
  ASSERT_EQ(swept.size(), 2u);
  EXPECT_EQ(swept[0].name, "eccentricity_m");
  EXPECT_EQ(swept[1].name, "b");
}

TEST(Grid, AnAxisRisesOrFallsOrIsInDisorder) {
  const auto disordered = [](std::vector<double> speed_hz, std::vector<double> of_key) {
    return disordered_axis(
        {std::move(speed_hz), UnbalanceMeasure::whirl_ratio, {0.2}, {{{"a"}, {1}, std::move(of_key)}}});
  };
  EXPECT_FALSE(disordered({50, 60, 70}, {3, 2, 1}));
  EXPECT_FALSE(disordered({50}, {1}));
  EXPECT_EQ(disordered({50, 70, 60}, {1, 2}), "speed_hz");
  EXPECT_EQ(disordered({50, 60}, {1, 3, 2}), "a");
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
