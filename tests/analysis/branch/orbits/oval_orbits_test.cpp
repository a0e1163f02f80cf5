#include "rubsweep/analysis/branch/orbits/oval_orbits.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>
#include <utility>

#include "core/response/annular_cell.hpp"
#include "rubsweep/analysis/branch/continuation/follow.hpp"
#include "rubsweep/analysis/branch/orbits/scene_orbits.hpp"
#include "rubsweep/core/response/settle.hpp"
#include "support/annular_scene.hpp"

namespace rubsweep::branch::orbits {
namespace {

/// The gyroscopic rotor in a frictionless elastic ring of Zilli, Battelino and Rosero and of Shaw, Champneys
/// and Friswell: z'' + (2 zeta - i J W) z' + z + beta (r - 1)(z / r) = m eps W^2 e^{i W t} for r > 1. In AUTO
/// its contact is smoothed by tanh 150 (r - 1), which changes r by less than 1e-4.
std::optional<scene::Scene> ring(double speed) {
  constexpr double damping = 0.01, polar = 0.143, drive = 0.9 * 0.353, beta = 10;
  scene::Scene scene = test::annular_scene(1, damping, speed, drive, 0, beta, 0);
  scene.structure.damping(0, 1) = polar * speed;
  scene.structure.damping(1, 0) = -polar * speed;
  return scene;
}

/// The oval on which the ring's rotor settles at W = 5 from a state, with its rates, in the rotating frame.
std::optional<continuation::BranchPoint> at_five(const OrbitProblem& problem, double u, double v, double du,
                                                 double dv) {
  constexpr double speed = 5;
  Eigen::VectorXd section(4);
  section << u, v, du / speed - v, dv / speed + u;
  response::motion::Workspace workspace;
  const auto state = oval_from(*ring(speed), section, {}, {}, workspace);
  return state ? continuation::orbit_from(problem, *state, speed) : std::nullopt;
}

OrbitProblem ring_problem(double low = 0, double high = 0) {
  OrbitProblem problem = oval_orbits(ring, 1, {});
  problem.parameter_scale = 2;
  problem.low = low;
  problem.high = high;
  return problem;
}

/// The stable part of the branch through an orbit.
continuation::Branch stable_branch(const OrbitProblem& problem, const continuation::BranchPoint& start) {
  continuation::FollowOptions options;
  options.stop_at_first_change = true;
  return continuation::follow_both_ways(problem, start, options);
}

/// Largest radius of the orbit at a parameter, on the first part of the branch that passes it.
std::optional<double> radius_at(const OrbitProblem& problem, const continuation::Branch& branch,
                                double parameter) {
  for (std::size_t i = 1; i < branch.points.size(); ++i) {
    const continuation::BranchPoint &a = branch.points[i - 1], &b = branch.points[i];
    if ((a.parameter - parameter) * (b.parameter - parameter) > 0) continue;
    const double share = (parameter - a.parameter) / (b.parameter - a.parameter);
    const auto orbit = continuation::orbit_from(problem, a.state + share * (b.state - a.state), parameter);
    if (orbit) return orbit->facts.peak_displacement_m;
  }
  return std::nullopt;
}

std::optional<continuation::BranchEvent> first_of(const continuation::Branch& branch,
                                                  continuation::EventKind kind, double near) {
  std::optional<continuation::BranchEvent> found;
  for (const continuation::BranchEvent& event : branch.events) {
    if (event.kind == kind &&
        (!found || std::abs(event.point.parameter - near) < std::abs(found->point.parameter - near)))
      found = event;
  }
  return found;
}

/// An undamped free rotor moves on an ellipse of 0.8 x 0.5 within the gap of 1, at half the shaft speed, so
/// it approaches the ring once per turn. The margin of an annular stop uses squared distances.
TEST(OvalOrbits, ApproachesInFlight) {
  const auto family = [](double speed) -> std::optional<scene::Scene> {
    return test::annular_scene(1, 0, speed, 0, 0, 10, 0);
  };
  const OrbitProblem problem = oval_orbits(family, 1, {});
  constexpr double turns = 2.5;
  Eigen::VectorXd state(5);
  state << 0.8, 0, 0, 0.25, turns;
  const auto passages = problem.passages(2, state);
  ASSERT_TRUE(passages);
  EXPECT_TRUE(passages->switches.empty());
  ASSERT_EQ(passages->approaches.size(), 2u);  // the first maximum is at the start
  for (const int k : {0, 1}) {
    const Approach& approach = passages->approaches.at(static_cast<std::size_t>(k));
    EXPECT_NEAR(approach.distance, (1 - 0.64) / 2, 1e-7);
    EXPECT_NEAR(approach.phase_rad, 2 * std::numbers::pi * (k + 1) / turns, 1e-4);
  }
}

TEST(OvalOrbits, SingleLoopInTheRing) {
  const OrbitProblem problem = ring_problem(4.2, 6.3);
  const auto start = at_five(problem, -0.704301, -0.464544, 2.512046, 1.197679);
  ASSERT_TRUE(start);
  EXPECT_TRUE(start->stable());
  const continuation::Branch branch = stable_branch(problem, *start);
  const auto doubling = first_of(branch, continuation::EventKind::period_doubling, 4.2691);
  ASSERT_TRUE(doubling);
  EXPECT_NEAR(doubling->point.parameter, 4.2691, 1e-4);
  EXPECT_NEAR(doubling->point.facts.peak_displacement_m, 1.9086, 2e-4);
  const auto fold = first_of(branch, continuation::EventKind::fold, 6.1658);
  ASSERT_TRUE(fold);
  EXPECT_NEAR(fold->point.parameter, 6.1658, 1e-4);
  EXPECT_NEAR(fold->point.facts.peak_displacement_m, 4.671, 1e-3);
  for (const auto& [speed, radius] : {std::pair(4.579686, 2.10052), std::pair(5.093012, 2.53949),
                                      std::pair(5.502124, 3.06875), std::pair(6.068488, 4.35986)})
    EXPECT_NEAR(radius_at(problem, branch, speed).value_or(0), radius, 1e-4) << speed;
}

TEST(OvalOrbits, DoubleLoopInTheRing) {
  const OrbitProblem problem = ring_problem(4.7, 6.3);
  const auto start = at_five(problem, -0.666092, -0.157668, -1.960638, -0.553556);
  ASSERT_TRUE(start);
  EXPECT_TRUE(start->stable());
  EXPECT_NEAR(start->facts.peak_displacement_m, 1.34176, 1e-4);
  const continuation::Branch branch = stable_branch(problem, *start);
  const auto doubling = first_of(branch, continuation::EventKind::period_doubling, 4.8624);
  ASSERT_TRUE(doubling);
  // AUTO's 4.8624 belongs to the smoothed contact and depends on its steepness 150: integrating the smoothed
  // equations gives 4.86243, and 4.86203 with a steepness of 300.
  EXPECT_NEAR(doubling->point.parameter, 4.8624, 6e-4);
  for (const auto& [speed, radius] : {std::pair(5.601550, 1.42315), std::pair(6.211858, 1.52799)})
    EXPECT_NEAR(radius_at(problem, branch, speed).value_or(0), radius, 1e-4) << speed;
}

/// On every orbit the damping determines the product of the multipliers, exp(-4 zeta T); the trivial
/// multiplier in it is 1. Two multipliers are zero: those of the shift along the orbit and of the time.
TEST(OvalOrbits, SectionsOfTheDoubledSingleLoop) {
  const auto start = at_five(ring_problem(4.2, 6.3), -0.704301, -0.464544, 2.512046, 1.197679);
  ASSERT_TRUE(start);
  const continuation::Branch branch = continuation::follow_both_ways(ring_problem(4.2, 6.3), *start, {});
  const auto doubling = std::ranges::find(branch.events, continuation::EventKind::period_doubling,
                                          &continuation::BranchEvent::kind);
  ASSERT_NE(doubling, branch.events.end());
  const OrbitProblem doubled = oval_orbits(ring, 2, {});
  const auto switched = continuation::doubled_start(doubled, doubling->point);
  ASSERT_TRUE(switched);
  ASSERT_EQ(switched->facts.sections.size(), 2u);
  for (const Eigen::VectorXd& section : switched->facts.sections) {
    Eigen::VectorXd returned = section;
    ASSERT_EQ(doubled.returns(switched->parameter, returned, nullptr), Evaluation::ok);
    EXPECT_LT((returned - section).cwiseAbs().maxCoeff(), 1e-8);
  }
}

TEST(OvalOrbits, MultipliersOfTheRing) {
  const OrbitProblem problem = ring_problem(4.2, 6.3);
  const auto start = at_five(problem, -0.704301, -0.464544, 2.512046, 1.197679);
  ASSERT_TRUE(start);
  ASSERT_EQ(start->multipliers.size(), 5);
  const double time = start->facts.period_turns * 2 * std::numbers::pi / start->parameter;
  const std::complex<double> product = start->multipliers(0) * start->multipliers(1) * start->multipliers(2);
  EXPECT_NEAR(product.real(), std::exp(-4 * 0.01 * time), 1e-8);
  EXPECT_NEAR(product.imag(), 0, 1e-10);
  EXPECT_LT(std::abs(start->multipliers(3)), 1e-7);
  EXPECT_LT(std::abs(start->multipliers(4)), 1e-7);
}

/// Compares the derivative of the map with differences of the map.
TEST(OvalOrbits, DerivativeOfTheMap) {
  const OrbitProblem problem = ring_problem();
  const auto start = at_five(problem, -0.704301, -0.464544, 2.512046, 1.197679);
  ASSERT_TRUE(start);
  Eigen::VectorXd off = start->state;
  off(1) += 1e-3;
  Eigen::MatrixXd derivative;
  Eigen::VectorXd image = off;
  ASSERT_EQ(problem.returns(5, image, &derivative), Evaluation::ok);
  constexpr double h = 1e-6;
  for (Eigen::Index k = 0; k < off.size(); ++k) {
    Eigen::VectorXd above = off, below = off;
    above(k) += h;
    below(k) -= h;
    ASSERT_EQ(problem.returns(5, above, nullptr), Evaluation::ok);
    ASSERT_EQ(problem.returns(5, below, nullptr), Evaluation::ok);
    EXPECT_LT(((above - below) / (2 * h) - derivative.col(k)).cwiseAbs().maxCoeff(), 2e-5) << k;
  }
}

/// An oval of a rotor with friction and a casing: orbit and multipliers agree with those proven by a settled
/// run.
TEST(OvalOrbits, AgreeWithASettledRun) {
  const scene::Cell cell = response::testing::annular_cell(165, 0.6);
  response::motion::Workspace workspace;
  const response::SettledRun settled = response::settle(cell, {}, {}, workspace);
  ASSERT_EQ(settled.motion.motion_class, response::motion::MotionClass::quasi_periodic);
  const SettledStart start = settle_on_orbit(cell, {}, {}, workspace);
  ASSERT_EQ(start.closing, Closing::in_the_turning_frame);
  OrbitProblem problem = oval_orbits(
      [](double speed_hz) -> std::optional<scene::Scene> {
        return response::testing::annular_cell(speed_hz, 0.6).scene;
      },
      1, {});
  problem.low = 160;
  problem.high = 170;
  problem.parameter_scale = 10;
  const auto orbit = continuation::orbit_from(problem, start.state, 165);
  ASSERT_TRUE(orbit);
  const response::motion::Measures& measures = settled.motion.measures;
  EXPECT_NEAR(1 / orbit->facts.period_turns, measures.comb_spacing.value(), 1e-8);
  EXPECT_NEAR(std::abs(orbit->multipliers(0)), settled.floquet_modulus.value(), 1e-6);
  EXPECT_NEAR(orbit->facts.peak_displacement_m, measures.contact.peak_displacement_m, 1e-9);
  EXPECT_NEAR(orbit->facts.peak_contact_force_n, measures.contact.peak_contact_force_n, 1e-3);
  EXPECT_NEAR(orbit->facts.contact_fraction, measures.contact.contact_fraction, 1e-6);
}

TEST(OvalOrbits, AreNoneWithoutSymmetry) {
  const OrbitProblem problem = oval_orbits(
      [](double speed) {
        auto scene = ring(speed);
        scene->constant_n(0) = 0.01;
        return scene;
      },
      1, {});
  Eigen::VectorXd state = Eigen::VectorXd::Ones(5);
  EXPECT_EQ(problem.returns(5, state, nullptr), Evaluation::infeasible);
  EXPECT_FALSE(problem.facts(5, state));
}

}  // namespace
}  // namespace rubsweep::branch::orbits
