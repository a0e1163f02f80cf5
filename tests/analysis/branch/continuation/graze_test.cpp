#include "rubsweep/analysis/branch/continuation/graze.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <vector>

#include "analysis/branch/two_mass.hpp"
#include "rubsweep/analysis/branch/continuation/follow.hpp"

namespace rubsweep::branch::continuation {
namespace {

/// The whole branch of period-one orbits between two speeds, started from the orbit without contact.
class GrazeTwoMasses : public ::testing::Test {
 protected:
  GrazeTwoMasses() {
    orbits::OrbitProblem problem = orbits::scene_orbits(
        [](double speed) -> std::optional<scene::Scene> { return test::two_mass_scene(speed); }, 1, {},
        modes_);
    problem.low = 0.4;
    problem.high = 0.9;
    const auto start = orbit_from(problem, Eigen::VectorXd::Zero(4), 0.5);
    if (start) branch_ = follow(problem, *start, {});
  }

  std::vector<BranchEvent> of(EventKind kind) const {
    std::vector<BranchEvent> events;
    std::ranges::copy_if(branch_.events, std::back_inserter(events),
                         [&](const BranchEvent& event) { return event.kind == kind; });
    return events;
  }

  integrate::exact::modes::ModeCache modes_;
  HalfBranch branch_;
};

/// Closed form: the linear response has the amplitude 1 at the graze.
TEST_F(GrazeTwoMasses, GrazesWhereTheLinearResponseReachesTheStop) {
  const auto grazes = of(EventKind::graze);
  ASSERT_EQ(grazes.size(), 2u);
  EXPECT_NEAR(grazes[0].point.parameter, 0.5818996390393, 1e-11);
  EXPECT_NEAR(grazes[1].point.parameter, 0.6534401404163, 1e-11);
  EXPECT_EQ(grazes[0].detail, "hit at stop 0 appears");
  EXPECT_EQ(grazes[1].detail, "hit at stop 0 disappears");
  for (const BranchEvent& graze : grazes) {
    EXPECT_LT(graze.parameter_error, 1e-11);
    const double w = graze.point.parameter;
    const std::complex<double> k(1, 0.03 * w), m(w * w, 0);
    // Linear response from [k - m, -k; -k, 2 k - m] q = (0, 0.1).
    EXPECT_NEAR(std::abs(0.1 * k / ((k - m) * (2.0 * k - m) - k * k)), 1, 1e-10);
  }
}

/// Values and their order along the branch: four digits from Krack and Gross's example and from shooting.
TEST_F(GrazeTwoMasses, TorusDoublingsAndFold) {
  const auto tori = of(EventKind::neimark_sacker), doublings = of(EventKind::period_doubling),
             folds = of(EventKind::fold);
  ASSERT_EQ(tori.size(), 2u);  // one of them is just above the graze
  EXPECT_NEAR(tori[1].point.parameter, 0.6186, 5e-5);
  ASSERT_EQ(doublings.size(), 2u);
  EXPECT_NEAR(doublings[0].point.parameter, 0.7388, 5e-5);
  EXPECT_NEAR(doublings[1].point.parameter, 0.7556, 5e-5);
  ASSERT_EQ(folds.size(), 2u);  // one of them is just below the graze
  EXPECT_NEAR(folds[0].point.parameter, 0.7556, 5e-5);
  EXPECT_GT(folds[0].point.parameter, doublings[1].point.parameter);
  EXPECT_LT(folds[1].point.parameter, 0.6534401404163);
  EXPECT_EQ(branch_.ending, Ending::left_range);
}

/// With an undamped contact only the dampers contract volumes in the state space: the product of the
/// multipliers is exp(-trace(D) T).
TEST_F(GrazeTwoMasses, ProductOfTheMultipliers) {
  for (const BranchPoint& point : branch_.points) {
    const double expected = std::exp(-0.09 * 2 * std::numbers::pi / point.parameter);
    EXPECT_NEAR(point.multipliers.prod().real() / expected, 1, 1e-8) << point.parameter;
  }
}

TEST_F(GrazeTwoMasses, MultipliersAtAPublishedSpeed) {
  orbits::OrbitProblem problem = orbits::scene_orbits(
      [](double speed) -> std::optional<scene::Scene> { return test::two_mass_scene(speed); }, 1, {}, modes_);
  const auto near = std::ranges::find_if(
      branch_.points, [](const BranchPoint& point) { return point.facts.touched && point.parameter > 0.62; });
  ASSERT_NE(near, branch_.points.end());
  const auto at = orbit_from(problem, near->state, 0.635);
  ASSERT_TRUE(at);
  EXPECT_TRUE(at->stable());
  EXPECT_EQ(at->facts.hits, 1);
  EXPECT_NEAR(at->multipliers(0).real(), 0.2763, 5e-5);
  EXPECT_NEAR(at->multipliers(0).imag(), 0.8416, 5e-5);
  EXPECT_NEAR(at->multipliers(2).real(), -0.4783, 5e-5);
  EXPECT_NEAR(at->multipliers(2).imag(), 0.5425, 5e-5);
}

/// The facts of every point of the branch agree with each other.
TEST_F(GrazeTwoMasses, FactsOfItsOrbits) {
  for (const BranchPoint& point : branch_.points) {
    EXPECT_TRUE(point.facts.feasible);
    EXPECT_EQ(point.facts.touched, point.facts.peak_displacement_m > 1) << point.parameter;
    EXPECT_EQ(point.facts.hits > 0, point.facts.contact_fraction > 0);
  }
}

}  // namespace
}  // namespace rubsweep::branch::continuation
