#include "rubsweep/maps/report/study_columns.hpp"

#include <gtest/gtest.h>

#include "rubsweep/maps/report/map_csv.hpp"

namespace rubsweep::report {
namespace {

sweep::Grid in_units_of_the_shop() {
  sweep::Grid grid{.speed_hz = {50}, .measure = sweep::UnbalanceMeasure::eccentricity_m, .unbalance = {3e-4}};
  grid.written_speed = {.key = "speed_rpm", .unit = "rpm", .units_per_si = 60};
  grid.written_unbalance = {.key = "unbalance_g_mm", .unit = "g mm", .units_per_si = 0.7e6};
  return grid;
}

TEST(StudyColumnsUnitColumns, SayWhatThePersonWroteNotWhatRoundingMadeOfIt) {
  const sweep::Grid grid = in_units_of_the_shop();
  EXPECT_EQ(unit_header(grid), ",speed_rpm,unbalance_g_mm");
  for (int rpm = 1; rpm < 20000; ++rpm) {
    sweep::Row row;
    row.speed_hz = rpm / 60.0;
    row.eccentricity_m = 0.1 * rpm / 0.7e6;
    const std::string written = unit_cells(row, grid);
    ASSERT_TRUE(written.starts_with("," + std::to_string(rpm) + ",")) << written;
    ASSERT_LE(written.size(), 14U) << written << ": 0.1 g mm and no digits of rounding";
    ASSERT_EQ(unit_cells(std::string_view(map_line(row)), grid), written);
  }
}

TEST(StudyColumnsUnitColumns, AreNoneWhereAllIsInSi) {
  EXPECT_EQ(unit_header({}), "");
  EXPECT_EQ(unit_cells(sweep::Row{}, {}), "");
}

TEST(StudyColumnsUnitColumns, LeaveTheHeaderThatEveryMapHas) {
  const std::string plain = map_header();
  EXPECT_EQ(without_unit_columns(plain + unit_header(in_units_of_the_shop())), plain);
  EXPECT_EQ(without_unit_columns(plain), plain);
}

}  // namespace
}  // namespace rubsweep::report
