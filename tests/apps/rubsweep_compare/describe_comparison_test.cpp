#include "rubsweep_compare/describe_comparison.hpp"

#include <gtest/gtest.h>

namespace rubsweep::apps {
namespace {

const std::string label_a("chaotic"), label_b("subharmonic 1/2");

MapComparison of_cells(int count, CellVerdict verdict) {
  MapComparison comparison;
  comparison.axis = std::string("whirl_ratio");
  comparison.keys.emplace_back("kick.force_n");
  for (int i = 0; i < count; ++i)
    comparison.cells.push_back({50.0 + i, 0.2, {30}, verdict, label_a, label_b});
  return comparison;
}

TEST(DescribeComparison, NamesTwentyCellsAndCountsTheRest) {
  const std::string text = describe_comparison(of_cells(23, CellVerdict::classes_differ), 1e-4);
  EXPECT_NE(text.find("23 cells: 0 equal, 23 with another class, 0 with other numbers (beyond 0.0001)"),
            std::string::npos);
  EXPECT_NE(text.find("  speed_hz 69, whirl_ratio 0.2, kick.force_n 30: chaotic -> subharmonic 1/2\n"),
            std::string::npos);
  EXPECT_EQ(text.find("speed_hz 70,"), std::string::npos);
  EXPECT_NE(text.find("  ... and 3 more\n"), std::string::npos);
  EXPECT_TRUE(text.ends_with("different\n"));
}

TEST(DescribeComparison, SaysWhatWasNotCompared) {
  MapComparison comparison = of_cells(2, CellVerdict::sensitive);
  comparison.missing_columns.emplace_back("peak_over_clearance");
  comparison.digest_a = std::string("a");
  comparison.digest_b = std::string("b");
  const std::string text = describe_comparison(comparison, 0);
  EXPECT_TRUE(text.starts_with("digests: a and b, two studies\n"));
  EXPECT_NE(text.find("not compared: 2 sensitive cells, 2 of them with another class\n"), std::string::npos);
  EXPECT_NE(text.find("not compared: peak_over_clearance, which only one of the maps has\n"),
            std::string::npos);
  EXPECT_TRUE(text.ends_with("equal\n"));
}

}  // namespace
}  // namespace rubsweep::apps
