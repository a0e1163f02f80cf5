#include "rubsweep/core/model/support.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <string>

namespace rubsweep::model {
namespace {

TEST(Support, TakesItsCoefficientsInTheOrderOfATable) {
  Support support;
  set_coefficients(support, {1, 2, 3, 4, 5, 6, 7, 8, 9, 10});
  const std::array set{support.stiffness_x_n_per_m,
                       support.stiffness_xy_n_per_m,
                       support.stiffness_yx_n_per_m,
                       support.stiffness_y_n_per_m,
                       support.damping_x_ns_per_m,
                       support.damping_xy_ns_per_m,
                       support.damping_yx_ns_per_m,
                       support.damping_y_ns_per_m,
                       support.mass_x_kg,
                       support.mass_y_kg};
  for (std::size_t i = 0; i < set.size(); ++i) EXPECT_EQ(set[i], static_cast<double>(i + 1));
}

TEST(Support, WithATableHasTheCoefficientsOfTheMiddleSpeed) {
  SupportTable table{.speed_hz = {10, 20, 30}, .columns = {}};
  for (std::size_t c = 0; c < table.columns.size(); ++c)
    table.columns[c] = {0, 100.0 + static_cast<double>(c), 0};
  const Support support = with_table({}, table);
  ASSERT_TRUE(support.table);
  EXPECT_EQ(support.table->speed_hz, table.speed_hz);
  EXPECT_EQ(support.stiffness_x_n_per_m, 100);
  EXPECT_EQ(support.mass_y_kg, 109);
}

TEST(SupportHousingProblem, SaysWhatExcludesAHousing) {
  Support support;
  EXPECT_FALSE(housing_problem(support));
  support.at_housing = 0;
  support.on_housing = 1;
  EXPECT_FALSE(housing_problem(support));
  support.on_housing = 0;
  EXPECT_EQ(housing_problem(support)->key, std::string("on_housing"));
  support.on_housing = 1;
  support.angular_stiffness_nm_per_rad = 5;
  EXPECT_EQ(housing_problem(support)->key, std::string("at_housing"));
  support.angular_stiffness_nm_per_rad = 0;
  support.pedestal = Pedestal{};
  EXPECT_EQ(housing_problem(support)->wrong, std::string("given beside a pedestal"));
}

}  // namespace
}  // namespace rubsweep::model
