#include "rubsweep/maps/config/study/sweep.hpp"

#include "maps/config/support.hpp"

namespace rubsweep::config::study {
namespace {

sweep::Grid grid_with(const std::vector<std::string>& overrides) {
  return read_run_config_text(test_file("minimal.yaml"), "test.yaml", overrides).study.grid;
}

TEST(Sweep, SpacesWholeNumbersExactly) {
  const std::vector<double> speeds = grid_with({"sweep.speed_hz={from: 45, to: 240, count: 66}"}).speed_hz;
  ASSERT_EQ(speeds.size(), 66U);
  for (std::size_t i = 0; i < speeds.size(); ++i) EXPECT_EQ(speeds[i], 45 + 3 * static_cast<double>(i));
}

TEST(Sweep, EndsExactlyWhereAsked) {
  const std::vector<double> ratios =
      grid_with({"sweep.whirl_ratio={from: 0.02, to: 0.98, count: 20}"}).unbalance;
  ASSERT_EQ(ratios.size(), 20U);
  EXPECT_EQ(ratios.front(), 0.02);
  EXPECT_EQ(ratios.back(), 0.98);
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    EXPECT_NEAR(ratios[i], (0.02 * (19 - static_cast<double>(i)) + 0.98 * static_cast<double>(i)) / 19,
                1e-15);
  }
}

TEST(Sweep, RunsDownwardsToo) {
  EXPECT_EQ(grid_with({"sweep.speed_hz={from: 90, to: 60, count: 4}"}).speed_hz,
            (std::vector<double>{90, 80, 70, 60}));
}

TEST(Sweep, TakesASingleValue) {
  const std::vector<double> one{60};
  EXPECT_EQ(grid_with({"sweep.speed_hz={from: 60, count: 1}"}).speed_hz, one);
  EXPECT_EQ(grid_with({"sweep.speed_hz={from: 60, to: 60, count: 1}"}).speed_hz, one);
  EXPECT_EQ(grid_with({"sweep.speed_hz={values: [60]}"}).speed_hz, one);
}

TEST(Sweep, KeepsListedValuesInTheirOrder) {
  EXPECT_EQ(grid_with({"sweep.speed_hz={values: [70, 60.5, 1e2]}"}).speed_hz,
            (std::vector<double>{70, 60.5, 100}));
}

TEST(Sweep, TakesEitherMeasureOfUnbalance) {
  const sweep::Grid ratio = grid_with({"sweep.whirl_ratio={values: [0, 1.5]}"});
  EXPECT_EQ(ratio.measure, sweep::UnbalanceMeasure::whirl_ratio);
  EXPECT_EQ(ratio.unbalance, (std::vector<double>{0, 1.5}));
  const sweep::Grid eccentricity =
      grid_with({"sweep={speed_hz: {values: [60]}, eccentricity_m: {values: [1e-5]}}"});
  EXPECT_EQ(eccentricity.measure, sweep::UnbalanceMeasure::eccentricity_m);
  EXPECT_EQ(eccentricity.unbalance, std::vector<double>{1e-5});
}

TEST(Sweep, ReadsItsRefinement) {
  EXPECT_FALSE(grid_with({}).refinement);
  const auto refinement = grid_with({"sweep.refine={levels: 3, probes: 2}"}).refinement;
  ASSERT_TRUE(refinement);
  EXPECT_EQ(refinement->levels, 3);
  EXPECT_EQ(refinement->probes, 2);
  EXPECT_EQ(message_of(test_file("minimal.yaml"),
                       {"sweep.speed_hz={values: [60, 80, 70]}", "sweep.refine={levels: 1}"}),
            "--set sweep.refine={levels: 1}: sweep.refine: beside values of speed_hz in no order, allowed: "
            "values that rise, or fall, all along");
  EXPECT_EQ(message_of(test_file("minimal.yaml"), {"sweep.refine={probes: 2}"}),
            "--set sweep.refine={probes: 2}: sweep.refine.levels: missing, allowed: an integer from 1 to 12");
}

TEST(Sweep, RefusesZeroAsOneValueTwice) {
  EXPECT_EQ(
      message_of(test_file("minimal.yaml"), {"sweep.whirl_ratio={values: [0, -0]}"}),
      "--set sweep.whirl_ratio={values: [0, -0]}: sweep.whirl_ratio.values.1: -0 is listed twice, allowed: "
      "different values");
}

TEST(Sweep, TakesUpToFourMillionCells) {
  const std::string speeds = "sweep.speed_hz={from: 1, to: 2999, count: 2000}";
  EXPECT_EQ(
      message_of(test_file("minimal.yaml"), {speeds, "sweep.whirl_ratio={from: 0, to: 1, count: 2000}"}),
      "no error");
  EXPECT_NE(
      message_of(test_file("minimal.yaml"), {speeds, "sweep.whirl_ratio={from: 0, to: 1, count: 2001}"}),
      "no error");
}

TEST(Sweep, RefusesASpacingThatOverflows) {
  EXPECT_NE(message_of(test_file("minimal.yaml"), {"sweep.speed_hz={from: 1, to: 1e308, count: 5}"}),
            "no error");
}

}  // namespace
}  // namespace rubsweep::config::study
