#include "rubsweep/analysis/branch/continuation/margins.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "analysis/branch/continuation/plain_maps.hpp"
#include "analysis/branch/two_mass.hpp"
#include "rubsweep/analysis/branch/continuation/bifurcations.hpp"
#include "rubsweep/analysis/branch/continuation/follow.hpp"
#include "rubsweep/analysis/branch/orbits/multipliers.hpp"

namespace rubsweep::branch::continuation {
namespace {

/// x -> A(p) x has the orbit 0 with the monodromy matrix A = diag(p, 2 p^2, 0.5).
orbits::OrbitProblem linear() {
  orbits::OrbitProblem problem;
  problem.low = 0;
  problem.high = 1;
  problem.returns = [](double p, Eigen::VectorXd& x, Eigen::MatrixXd* monodromy) {
    const Eigen::Vector3d diagonal(p, 2 * p * p, 0.5);
    if (monodromy) *monodromy = diagonal.asDiagonal();
    x = diagonal.cwiseProduct(x).eval();
    return p > 0.9 ? orbits::Evaluation::infeasible : orbits::Evaluation::ok;
  };
  return problem;
}

/// The orbit stays at rest, so the branch runs along p: slopes are the derivatives of polynomials in p.
TEST(MarginsMultiplierSlopes, OfPolynomials) {
  const orbits::OrbitProblem problem = linear();
  for (const double p : {0.4, 0.8999999}) {  // also close to the end of the allowed range
    const auto point = orbit_from(problem, Eigen::Vector3d::Zero(), p);
    ASSERT_TRUE(point);
    const double a = p, b = 2 * p * p, c = 0.5, db = 4 * p;
    const MultiplierTests tests = tests_of_multipliers(point->multipliers);
    EXPECT_NEAR(tests.unit, (1 - a) * (1 - b) * (1 - c), 1e-14);
    EXPECT_NEAR(tests.doubling, (1 + a) * (1 + b) * (1 + c), 1e-14);
    EXPECT_NEAR(tests.torus, (a * b - 1) * (a * c - 1) * (b * c - 1), 1e-14);
    const MultiplierTests slopes = multiplier_slopes(problem, *point);
    EXPECT_NEAR(slopes.unit, -(1 - b) * (1 - c) - db * (1 - a) * (1 - c), 3e-4);
    EXPECT_NEAR(slopes.doubling, (1 + b) * (1 + c) + db * (1 + a) * (1 + c), 3e-4);
    const double by_torus = (b + a * db) * (a * c - 1) * (b * c - 1) + (a * b - 1) * c * (b * c - 1) +
                            (a * b - 1) * (a * c - 1) * db * c;
    EXPECT_NEAR(slopes.torus, by_torus, 3e-4);
  }
}

/// Along the logistic map's fixed points 1 - 1 / r the multiplier is 2 - r. The arclength exceeds the change
/// of r.
TEST(MarginsMultiplierSlopes, AlongACurvedBranchPerUnitOfItsLength) {
  orbits::OrbitProblem problem = test::logistic(1, 1.5, 4);
  problem.parameter_scale = 2.5;
  const auto point = orbit_from(problem, test::number(0.5), 2);
  ASSERT_TRUE(point);
  EXPECT_NEAR(multiplier_slopes(problem, *point).unit, 2.5 * point->tangent(1), 3e-4);
  const BranchPoint turned = turned_about(*point);
  EXPECT_NEAR(multiplier_slopes(problem, turned).unit, -2.5 * point->tangent(1), 3e-4);
}

/// Dip of a (s - r) (s - q) on a step of this length.
std::optional<double> dip_of_parabola(double a, double r, double q, double length) {
  const auto value = [&](double s) { return a * (s - r) * (s - q); };
  const auto slope = [&](double s) { return a * (2 * s - r - q); };
  return dip_of_cubic({value(0), value(length), slope(0), slope(length)}, length);
}

/// The extremum lies midway between the roots, whatever the sign of the function.
TEST(MarginsDip, BetweenTwoRoots) {
  for (const double a : {3.0, -0.2}) {
    const auto share = dip_of_parabola(a, 0.1, 0.3, 0.5);
    ASSERT_TRUE(share);
    EXPECT_NEAR(*share, 0.2 / 0.5, 1e-14);
    EXPECT_TRUE(dip_of_parabola(a, 0.499, 0.4995, 0.5)) << "at the very end";
  }
}

TEST(MarginsDip, NoneWhereOneRootOrNoneIsInside) {
  EXPECT_FALSE(dip_of_parabola(1, 0.2, 0.7, 0.5));
  EXPECT_FALSE(dip_of_parabola(1, -0.2, -0.1, 0.5));
  EXPECT_FALSE(dip_of_parabola(1, 0.6, 0.9, 0.5));
}

/// (s - 1/2)^2 + c on 0 <= s <= 1: only values that come close to zero are examined.
TEST(MarginsDip, NearlyARoot) {
  const auto above = [](double c) { return dip_of_cubic({0.25 + c, 0.25 + c, -1, 1}, 1); };
  EXPECT_TRUE(above(0.01));
  EXPECT_FALSE(above(0.3));
}

/// (s - 0.2) (s - 0.5) (s - 0.9): the signs at both ends show one root; there are two more.
TEST(MarginsDip, ThreeRoots) {
  const auto value = [](double s) { return (s - 0.2) * (s - 0.5) * (s - 0.9); };
  const auto slope = [](double s) { return 3 * s * s - 3.2 * s + 0.73; };
  const auto share = dip_of_cubic({value(0), value(1), slope(0), slope(1)}, 1);
  ASSERT_TRUE(share);
  EXPECT_NEAR(slope(*share), 0, 1e-14);
  EXPECT_GT(value(*share), 0) << "the first extremum";
  // One root, and before it an extremum far from zero: s^3 - s + 1 on -1.5 <= s <= 0.
  EXPECT_FALSE(dip_of_cubic({-0.875, 1, 5.75, -1}, 1.5));
}

/// A quadratic given by its end values and its mean: (s - 0.3) (s - 0.6) over 0 <= s <= 1.
TEST(MarginsDip, OfAQuadraticByItsMean) {
  const auto share = dip_of_quadratic(0.18, 0.28, 1.0 / 3 - 0.45 + 0.18);
  ASSERT_TRUE(share);
  EXPECT_NEAR(*share, 0.45, 1e-14);
  EXPECT_FALSE(dip_of_quadratic(1, 2, 1.5)) << "a straight line";
}

/// Events on the single step between the orbits at the angular frequencies `first` and `last` of a family of
/// scenes. Both ends have the same contact modes, so only margins can detect the events.
std::vector<BranchEvent> on_one_step(const orbits::SceneFamily& family, double first, double last) {
  integrate::exact::modes::ModeCache modes;
  orbits::OrbitProblem problem = orbits::scene_orbits(family, 1, {}, modes);
  problem.low = first;
  problem.high = last;
  problem.parameter_scale =
      (last - first) / 10;  // the state changes little over this difference, so the tangent stays the same
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(4);
  const auto from = orbit_from(problem, rest, first);
  auto to = orbit_from(problem, rest, last);
  if (!from || !to) {
    ADD_FAILURE() << "no orbits";
    return {};
  }
  EXPECT_TRUE(orbits::same_sequence(from->facts.switches, to->facts.switches));
  to->arclength = last - first;
  const auto events = events_between(problem, *from, *to, true);
  if (!events) ADD_FAILURE() << "not one piece";
  return events.value_or(std::vector<BranchEvent>{});
}

/// Expects two grazes: contact sequence `begins` starts at the first one, `ends` ends at the second one.
void expect_two(const std::vector<BranchEvent>& events, double first, double second,
                const std::string& begins, const std::string& ends) {
  ASSERT_EQ(events.size(), 2u);
  for (const BranchEvent& event : events) {
    EXPECT_EQ(event.kind, EventKind::graze) << to_string(event.kind);
    EXPECT_LT(event.parameter_error, 1e-11);
  }
  EXPECT_NEAR(events[0].point.parameter, first, 1e-10);
  EXPECT_NEAR(events[1].point.parameter, second, 1e-10);
  EXPECT_EQ(events[0].detail, begins);
  EXPECT_EQ(events[1].detail, ends);
}

/// Solutions w of (stiffness - w^2)^2 + (damping w)^2 = ratio^2, the lower one first.
std::pair<double, double> frequencies_of(double stiffness, double damping, double ratio) {
  const double middle = stiffness - damping * damping / 2,
               width = std::sqrt(middle * middle - stiffness * stiffness + ratio * ratio);
  return {std::sqrt(middle - width), std::sqrt(middle + width)};
}

/// A unit mass on a unit spring and a damper of 0.4, driven by `force` cos(w t), before a soft wall at 1.
/// Without contact its amplitude is force / |1 - w^2 + 0.4 i w|, at most force / 0.39192.
orbits::SceneFamily before_a_wall(double force) {
  return [force](double w) -> std::optional<scene::Scene> {
    scene::Scene scene = test::one_mass_scene(1, 1, 0.4, 2 * std::numbers::pi / w, 1);
    scene.harmonic_n << force, 0;
    scene.contacts.push_back(test::wall_across_x(1, 1, 1, 0));
    return scene;
  };
}

/// The resonance exceeds the wall by 0.2 %, and both ends of the step are far from it.
TEST(Margins, AHitThatComesAndGoesInOneStep) {
  const double force = 0.3927;
  const auto [first, second] = frequencies_of(1, 0.4, force);
  expect_two(on_one_step(before_a_wall(force), 0.8, 1.1), first, second, "hit at stop 0 appears",
             "hit at stop 0 disappears");
}

TEST(Margins, AResonanceThatDoesNotReachTheWall) {
  EXPECT_TRUE(on_one_step(before_a_wall(0.3918), 0.8, 1.1).empty());
}

/// A mass pressed into the wall by 0.3 vibrates on two unit springs and just loses contact at resonance.
TEST(Margins, AFlightThatComesAndGoesInOneStep) {
  const double depth = 0.3, ratio = 0.5605;
  const auto family = [&](double w) {
    auto scene = before_a_wall(ratio * depth)(w);
    scene->constant_n(0) = 1 + 2 * depth;
    return scene;
  };
  const auto [first, second] = frequencies_of(2, 0.4, ratio);
  expect_two(on_one_step(family, 1.2, 1.55), first, second, "sprung interrupted at stop 0 appears",
             "sprung interrupted at stop 0 disappears");
}

/// Between two resonances the response falls just below the gap.
TEST(Margins, AHitThatGoesAndComesBackInOneStep) {
  static constexpr double force = 1.245;
  const auto family = [](double w) -> std::optional<scene::Scene> {
    scene::Scene scene = test::two_mass_scene(w);
    scene.harmonic_n(1) = force;
    scene.contacts[0].stiffness_n_per_m = 0.05;
    return scene;
  };
  const auto amplitude = [](double w) {
    const std::complex<double> k(1, 0.03 * w), m(w * w, 0);
    return std::abs(force * k / ((k - m) * (2.0 * k - m) - k * k));
  };
  const auto events = on_one_step(family, 1.1, 1.33);
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[0].detail, "hit at stop 0 disappears");
  EXPECT_EQ(events[1].detail, "hit at stop 0 appears");
  EXPECT_LT(events[0].point.parameter, events[1].point.parameter - 0.01);
  for (const BranchEvent& event : events) EXPECT_NEAR(amplitude(event.point.parameter), 1, 1e-10);
}

/// Margin of the orbit without contact, 1 minus the amplitude, and its derivative by the frequency, in closed
/// form.
TEST(Margins, ValueAndSlopeOfAnApproach) {
  integrate::exact::modes::ModeCache modes;
  orbits::OrbitProblem problem = orbits::scene_orbits(before_a_wall(0.3), 1, {}, modes);
  const double w = 0.8;
  const auto point = orbit_from(problem, Eigen::VectorXd::Zero(4), w);
  ASSERT_TRUE(point);
  const auto margins = margins_of(problem, *point);
  ASSERT_EQ(margins.size(), 1u);
  const double square = std::pow(1 - w * w, 2) + 0.16 * w * w, amplitude = 0.3 / std::sqrt(square);
  EXPECT_NEAR(margins[0].value, 1 - amplitude, 1e-7);
  const double slope = amplitude / (2 * square) * (-4 * w * (1 - w * w) + 0.32 * w);
  EXPECT_NEAR(margins[0].slope, slope * point->tangent(4), 1e-4);
  EXPECT_EQ(margins[0].kind, Margin::Kind::approach);
}

/// Margins of the same kind are matched by the smallest difference of phase, also across the end of the
/// period.
TEST(Margins, AreMatchedByTheirPhases) {
  const auto margin = [](int contact, double phase_rad, double value, double slope) {
    return Margin{
        Margin::Kind::approach, contact, contact::Mode::open, contact::Mode::sprung, phase_rad, value, slope};
  };
  static constexpr double period_rad = 6;
  const std::vector<Margin> from{margin(0, 0.1, 1, -4), margin(0, 3, 1, 0)},
      to{margin(0, 3.1, 1, 0), margin(0, 5.9, 1, 4)};
  const auto share = share_of_dip(from, to, period_rad, 1, 1);
  ASSERT_TRUE(share);
  EXPECT_NEAR(*share, 0.5, 1e-12);
  EXPECT_FALSE(share_of_dip({margin(1, 0.1, 1, -4)}, to, period_rad, 1, 1)) << "another contact";
  EXPECT_FALSE(share_of_dip({from[1]}, {to[0]}, period_rad, 1, 1)) << "it comes no nearer";
}

}  // namespace
}  // namespace rubsweep::branch::continuation
