#include "rubsweep/maps/config/study/sweep.hpp"

#include "maps/config/study/with_sweep_lines.hpp"
#include "maps/config/support.hpp"
#include "rubsweep/maps/config/run_config.hpp"

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

std::string with_sweep(const std::string& speed, const std::string& unbalance, const std::string& more = "") {
  return with_sweep_lines(speed + "\n  " + unbalance + "\n" + more);
}

sweep::Grid grid(const std::string& speed, const std::string& unbalance, const std::string& more = "") {
  return read_run_config_text(with_sweep(speed, unbalance, more), "test.yaml", {}).study.grid;
}

std::string digest(const std::string& speed, const std::string& unbalance) {
  return study_digest(read_run_config_text(with_sweep(speed, unbalance), "test.yaml", {}).study);
}

const std::string speed = "speed_hz: {from: 50, to: 150, count: 6}";

TEST(SweepPlaceAxes, TakesSpeedsInRevolutionsPerMinute) {
  EXPECT_EQ(grid("speed_rpm: {from: 3000, to: 9000, count: 6}", ratio).speed_hz, grid(speed, ratio).speed_hz);
  EXPECT_EQ(grid("speed_rpm: {values: [4500, 3000]}", ratio).speed_hz, (std::vector<double>{75, 50}));
  EXPECT_EQ(grid("speed_rpm: 4500", ratio).speed_hz, std::vector<double>{75});
  EXPECT_EQ(grid("speed_hz: 75", ratio).speed_hz, std::vector<double>{75});
}

TEST(SweepPlaceAxes, TakesAnUnbalanceByTheMassOfTheRotor) {
  const sweep::Grid read = grid(speed, "unbalance_g_mm: {from: 80, to: 400, count: 5}");
  EXPECT_EQ(read.measure, sweep::UnbalanceMeasure::eccentricity_m);
  EXPECT_EQ(read.unbalance, grid(speed, "eccentricity_m: {from: 1e-4, to: 5e-4, count: 5}").unbalance);
}

TEST(SweepPlaceAxes, TakesAGradeAtTheRatedSpeedInEveryCell) {
  const sweep::Grid read =
      grid(speed, "balance_grade_mm_per_s: {values: [2.5, 6.3]}", "  rated_speed_rpm: 3000\n");
  ASSERT_EQ(read.measure, sweep::UnbalanceMeasure::eccentricity_m);
  ASSERT_EQ(read.unbalance.size(), 2U);
  // Published eccentricities of the balance grades: 8 and 20 micrometres at 3000 rpm.
  EXPECT_NEAR(read.unbalance[0], 7.96e-6, 0.01e-6);
  EXPECT_NEAR(read.unbalance[1], 20.05e-6, 0.01e-6);
  EXPECT_EQ(grid(speed, "balance_grade_mm_per_s: 6.3", "  rated_speed_hz: 50\n").unbalance.front(),
            read.unbalance[1]);
}

TEST(SweepPlaceAxes, CountsTheUnbalanceOfAKitByItsDiscs) {
  const std::string kit = test_file("rotor_kit.yaml");
  const RunConfig config = read_run_config_text(kit, "kit.yaml", {"sweep.unbalance_g_mm=100"});
  double mass_kg = 0;
  for (const model::Disc& disc : model::kit_of(config.study.machine)->discs)
    mass_kg += disc.mass_kg * std::abs(disc.eccentricity_ratio);
  ASSERT_GT(mass_kg, 0);
  EXPECT_DOUBLE_EQ(config.study.grid.unbalance.front() * mass_kg, 1e-4);
  EXPECT_EQ(message_of(kit, {"rotor.discs.0.eccentricity_ratio=0", "sweep.unbalance_g_mm=100"}, "kit.yaml"),
            "--set sweep.unbalance_g_mm=100: sweep.unbalance_g_mm: has no eccentricity: no disc of the rotor "
            "stands "
            "off the axis, allowed: a disc with a mass and an eccentricity_ratio, or whirl_ratio");
}

TEST(SweepPlaceAxes, IsTheSameStudyInSiUnits) {
  EXPECT_EQ(digest("speed_rpm: {from: 3000, to: 9000, count: 6}", "unbalance_g_mm: {values: [160]}"),
            digest(speed, "eccentricity_m: {values: [2e-4]}"));
  EXPECT_NE(digest("speed_rpm: {from: 3000, to: 9001, count: 6}", "unbalance_g_mm: {values: [160]}"),
            digest(speed, "eccentricity_m: {values: [2e-4]}"));
}

TEST(SweepPlaceAxes, IsPrintedAsItWasWrittenAndInSiUnitsForTheDigest) {
  const RunConfig config =
      read_run_config_text(with_sweep("speed_rpm: 4500", "unbalance_g_mm: 160"), "test.yaml", {});
  const std::string printed = print_config(config);
  EXPECT_NE(printed.find("  speed_rpm:\n    values: [4500]\n  unbalance_g_mm:\n    values: [160]\n"),
            std::string::npos)
      << printed;
  EXPECT_EQ(print_config(read_run_config_text(printed, "printed.yaml", {})), printed);
  const std::string study = config::print_study(config.study);
  EXPECT_NE(study.find("  speed_hz:\n    values: [75]\n  eccentricity_m:\n    values: [0.0002]\n"),
            std::string::npos)
      << study;
  EXPECT_EQ(study.find("rpm"), std::string::npos);
}

TEST(SweepPlaceAxes, RefusesAQuantityInTwoUnitsWithBothPlaces) {
  EXPECT_EQ(
      message_of(with_sweep(speed + "\n  speed_rpm: 3000", ratio)),
      "test.yaml:7:14: sweep.speed_rpm: given beside speed_hz (test.yaml:6:13), allowed: exactly one of "
      "speed_hz, speed_rpm");
  EXPECT_EQ(message_of(with_sweep(speed, "eccentricity_m: 1e-4\n  unbalance_g_mm: 80")),
            "test.yaml:8:19: sweep.unbalance_g_mm: given beside eccentricity_m (test.yaml:7:19), allowed: "
            "exactly one "
            "of whirl_ratio, eccentricity_m, unbalance_g_mm, balance_grade_mm_per_s");
  EXPECT_EQ(message_of(with_sweep(speed, "balance_grade_mm_per_s: 6.3",
                                  "  rated_speed_hz: 50\n  rated_speed_rpm: 1\n")),
            "test.yaml:9:20: sweep.rated_speed_rpm: given beside rated_speed_hz (test.yaml:8:19), allowed: "
            "exactly one "
            "of rated_speed_hz, rated_speed_rpm");
}

TEST(SweepPlaceAxes, WantsARatedSpeedWithAGradeAndOnlyThere) {
  EXPECT_EQ(
      message_of(with_sweep(speed, "balance_grade_mm_per_s: 6.3")),
      "test.yaml:6:3: sweep: one key is missing, allowed: exactly one of rated_speed_hz, rated_speed_rpm");
  EXPECT_EQ(
      message_of(with_sweep(speed, ratio, "  rated_speed_rpm: 3000\n")),
      "test.yaml:8:20: sweep.rated_speed_rpm: no grade is given that it would belong to, allowed: beside "
      "balance_grade_mm_per_s");
}

TEST(SweepPlaceAxes, SaysWhatIsWrongInTheUnitThatWasWritten) {
  EXPECT_EQ(message_of(with_sweep("speed_rpm: {from: -60, to: 60, count: 2}", ratio)),
            "test.yaml:6:21: sweep.speed_rpm.from: -60 is out of range, allowed: a number > 0");
  EXPECT_EQ(message_of(with_sweep(speed, "unbalance_g_mm: fast")),
            "test.yaml:7:19: sweep.unbalance_g_mm: 'fast' is not a number, allowed: a number >= 0");
  EXPECT_EQ(message_of(with_sweep("speed_rpm: 200000", ratio)),
            "test.yaml:6:14: sweep.speed_rpm: 200000 revolutions per minute is over 100 times "
            "the lowest natural frequency, allowed: at most 180000");
  EXPECT_EQ(message_of(with_sweep("speed_hz: 4500", ratio)),
            "test.yaml:6:13: sweep.speed_hz: 4500 Hz is over 100 times the lowest natural frequency "
            "(revolutions per "
            "minute?), allowed: at most 3000");
}

TEST(SweepPlaceAxes, AreTakenBackByAnOverrideInAnotherUnit) {
  const RunConfig config = read_run_config_text(with_sweep(speed, ratio), "test.yaml",
                                                {"sweep.speed_rpm=4500", "sweep.balance_grade_mm_per_s=6.3",
                                                 "sweep.rated_speed_hz=40", "sweep.rated_speed_rpm=3000"});
  EXPECT_EQ(config.study.grid.speed_hz, std::vector<double>{75});
  EXPECT_NEAR(config.study.grid.unbalance.front(), 20.05e-6, 0.01e-6);
}

TEST(SweepPlaceAxes, AreNoAxesOverKeys) {
  EXPECT_EQ(message_of(with_sweep(speed, ratio, "  x: {key: speed_rpm, values: [3000]}\n")),
            "test.yaml:8:12: speed_rpm: has an axis of its own, allowed: sweep.speed_rpm");
}

TEST(SweepPlaceAxes, RefusesAnAxisOverTheMassBehindAnUnbalance) {
  const std::string axis = "  x: {key: rotor.mass_kg, values: [1, 2]}\n";
  EXPECT_EQ(
      message_of(with_sweep(speed, "unbalance_g_mm: 80", axis)),
      "test.yaml:8:12: rotor.mass_kg: is part of the mass that sweep.unbalance_g_mm takes its eccentricities "
      "from, allowed: another key, or sweep.eccentricity_m or sweep.whirl_ratio");
  // For a Jeffcott rotor a balance grade determines the eccentricity, whatever its mass is.
  EXPECT_EQ(message_of(with_sweep(speed, "balance_grade_mm_per_s: 6.3", "  rated_speed_hz: 50\n" + axis)),
            "no error");
}

}  // namespace
}  // namespace rubsweep::config::study
