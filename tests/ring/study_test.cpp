#include "rubsweep/ring/study.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "ring/support.hpp"
#include "rubsweep/maps/batch/axis.hpp"
#include "rubsweep/ring/analysis.hpp"

namespace rubsweep::ring {
namespace {

const std::atomic<bool> never{false};

std::vector<std::optional<ChartLine>> chart(const System& system, const ChartAxis& axis, int threads) {
  return run_chart(
      system, axis, batch::evenly_spaced(0.0, 1500 * rpm, 51), threads, [](const ChartLine&) {}, never);
}

TEST(StudyChartRun, DoesNotDependOnTheNumberOfThreads) {
  const ChartAxis axis{Parameter::inclination_deg, {}, batch::evenly_spaced(-90.0, 90.0, 13)};
  const auto one = chart(spring_masses({60, 90}), axis, 1), two = chart(spring_masses({60, 90}), axis, 2);
  ASSERT_EQ(one.size(), 13U);
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i]->status, "ok");
    ASSERT_EQ(one[i]->points.size(), two[i]->points.size());
    for (std::size_t k = 0; k < one[i]->points.size(); ++k) {
      EXPECT_EQ(one[i]->points[k].growth_per_s, two[i]->points[k].growth_per_s);
      EXPECT_EQ(one[i]->points[k].signature, two[i]->points[k].signature);
    }
    ASSERT_EQ(one[i]->onsets.size(), two[i]->onsets.size());
    for (std::size_t k = 0; k < one[i]->onsets.size(); ++k) {
      EXPECT_EQ(one[i]->onsets[k].speed_rad_per_s, two[i]->onsets[k].speed_rad_per_s);
    }
  }
}

TEST(StudyChartRun, HasTheOnsetsOfTheSingleRuns) {
  const ChartAxis axis{Parameter::angle_deg, 1, {87, 110}};
  const auto lines = chart(spring_masses({60, 200}), axis, 1);
  for (const auto& line : lines) {
    std::vector<double> expected, found;
    for (const Onset& onset :
         analyse(spring_masses({60, line->value}), batch::evenly_spaced(0.0, 1500 * rpm, 301)).onsets) {
      if (onset.kind != "veering" && !onset.kind.starts_with("stable"))
        expected.push_back(onset.speed_rad_per_s);
    }
    for (const Onset& onset : line->onsets) found.push_back(onset.speed_rad_per_s);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-9);
  }
}

TEST(StudyChartRun, ALineThatCannotBeSolvedIsALineWithAStatus) {
  System system = spring_masses({0});
  system.loads[0] = beam(300, 140, 1e7, 1e6);
  system.loads[0].inclination_deg = 45;
  // det M is linear in the friction coefficient and zero at this value.
  system.friction_coefficient = 0;
  const double at_zero = assemble(system).mass.determinant();
  system.friction_coefficient = 1;
  const double critical = -at_zero / (assemble(system).mass.determinant() - at_zero);
  const auto lines = chart(system, {Parameter::friction_coefficient, {}, {0.1, critical}}, 1);
  EXPECT_EQ(lines[0]->status, "ok");
  EXPECT_EQ(lines[1]->status, "singular_mass");
  EXPECT_TRUE(lines[1]->points.empty());
}

TEST(StudyChartRun, StopsWhenTold) {
  const std::atomic<bool> now{true};
  const auto lines = run_chart(
      spring_masses({60}), {Parameter::friction_coefficient, {}, {0.1, 0.2}}, {1, 2}, 1,
      [](const ChartLine&) {}, now);
  EXPECT_FALSE(lines[0] || lines[1]);
}

TEST(StudyChartWithParameter, ChangesOneLoadOrAll) {
  const System system = spring_masses({60, 90});
  const System one = with_parameter(system, {Parameter::radial_stiffness_n_per_m, 1, {}}, 5);
  EXPECT_EQ(one.loads[0].radial_stiffness_n_per_m, 1e6);
  EXPECT_EQ(one.loads[1].radial_stiffness_n_per_m, 5);
  const System all = with_parameter(system, {Parameter::tangential_stiffness_n_per_m, {}, {}}, 7);
  EXPECT_EQ(all.loads[0].tangential_stiffness_n_per_m, 7);
  EXPECT_EQ(all.loads[1].tangential_stiffness_n_per_m, 7);
  EXPECT_EQ(with_parameter(system, {Parameter::friction_coefficient, {}, {}}, 0.3).friction_coefficient, 0.3);
  EXPECT_EQ(with_parameter(system, {Parameter::angle_deg, 0, {}}, -3).loads[0].angle_deg, -3);
  EXPECT_EQ(with_parameter(system, {Parameter::inclination_deg, 0, {}}, 4).loads[0].inclination_deg, 4);
}

}  // namespace

}  // namespace rubsweep::ring
