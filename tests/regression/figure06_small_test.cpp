// A small Figure 6 against results/golden/figure06_small.csv: class and order exactly, on every cell that a
// tenfold tighter tolerance leaves unchanged. The others are listed by name in figure06_small_sensitive.csv.
#include <gtest/gtest.h>

#include <atomic>
#include <set>
#include <string>
#include <utility>

#include "rubsweep/batch/csv_table.hpp"
#include "rubsweep/config/read_run_config.hpp"
#include "rubsweep/report/map_csv.hpp"
#include "rubsweep/sweep/run_map.hpp"

namespace rubsweep {
namespace {

const std::string golden_directory = RUBSWEEP_GOLDEN;

std::vector<std::optional<sweep::Row>> map_at(const std::string& tolerance) {
  const auto config = config::read_run_config(RUBSWEEP_TEST_DATA "/figure06_small.yaml",
                                              {"solver.relative_tolerance=" + tolerance});
  const std::atomic<bool> never{false};
  return sweep::run_map(
      config.study, 0, [](const sweep::Row&) {}, never);
}

std::string label(std::string_view motion_class, const std::string& order) {
  return std::string(motion_class) + (order.empty() ? "" : " " + order);
}

std::string label(const sweep::Row& row) {
  return label(response::to_string(row.motion_class), row.order ? std::to_string(*row.order) : "");
}

std::set<std::pair<double, double>> sensitive_cells() {
  const auto table = batch::read_csv(golden_directory + "/figure06_small_sensitive.csv");
  std::set<std::pair<double, double>> cells;
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    cells.emplace(batch::number(table, row, batch::column(table, "speed_hz")),
                  batch::number(table, row, batch::column(table, "whirl_ratio")));
  }
  return cells;
}

TEST(Figure06Small, ClassesAreTheGoldenOnesAtBothTolerances) {
  const auto golden = batch::read_csv(golden_directory + "/figure06_small.csv");
  const auto sensitive = sensitive_cells();
  // Golden maps may hold few cells that hang by a thread.
  EXPECT_LE(sensitive.size(), golden.rows.size() * 3 / 100);
  const auto class_column = batch::column(golden, "class"), order_column = batch::column(golden, "order");
  const auto peak_column = batch::column(golden, "peak_displacement_m");
  for (const std::string tolerance : {"1e-8", "1e-9"}) {
    const auto rows = map_at(tolerance);
    ASSERT_EQ(rows.size(), golden.rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const sweep::Row& row = rows[i].value();
      ASSERT_EQ(row.speed_hz, batch::number(golden, i, 0));
      ASSERT_EQ(row.whirl_ratio, batch::number(golden, i, 1));
      ASSERT_NE(row.motion_class, response::MotionClass::failed) << row.status;
      if (sensitive.contains({row.speed_hz, row.whirl_ratio})) continue;
      const std::string expected = label(golden.rows[i][class_column], golden.rows[i][order_column]);
      EXPECT_EQ(label(row), expected)
          << row.speed_hz << " Hz, whirl ratio " << row.whirl_ratio << ", " << tolerance;
      if (!row.order) continue;
      const double peak_m = batch::number(golden, i, peak_column);
      EXPECT_NEAR(row.measures->contact.peak_displacement_m, peak_m, 1e-4 * peak_m)
          << row.speed_hz << " Hz, whirl ratio " << row.whirl_ratio << ", " << tolerance;
    }
  }
}

}  // namespace
}  // namespace rubsweep
