#include "rubsweep/analysis/branch/orbits/scene_plane.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>

#include "analysis/branch/orbits/full_rub.hpp"
#include "analysis/branch/two_mass.hpp"
#include "rubsweep/analysis/branch/continuation/follow.hpp"
#include "rubsweep/analysis/branch/curves/follow_curve.hpp"
#include "rubsweep/core/integrate/run/state_scale.hpp"
#include "support/annular_scene.hpp"
#include "support/simple_scenes.hpp"

namespace rubsweep::branch::orbits {
namespace {

using contact::Mode;

/// A mass of 2 kg on 8 N/m, driven by 3 cos t at a speed of 1 rad/s, with a wall at 1 m; lengths in metres.
scene::Scene driven_mass(double damping) {
  scene::Scene scene = test::one_mass_scene(2, 8, 0, 2 * std::numbers::pi, 1);
  scene.harmonic_n << 3, 0;
  scene.contacts.push_back(test::wall_across_x(1, 1, 50, damping));
  return scene;
}

TEST(ScenePlaneGuardMotionSection, AnOpenContactInClosedForm) {
  SectionGuards guards(driven_mass(0));
  const std::array section{0.9, 0.1, 0.2, -0.3};
  const auto guard = guards.at(section, {0, Mode::open, Mode::sprung});
  ASSERT_TRUE(guard);
  EXPECT_NEAR(guard->value, 0.9 - 1, 1e-15);
  EXPECT_NEAR(guard->rate, 0.2, 1e-15);
  EXPECT_NEAR(guard->curvature, (3 - 8 * 0.9) / 2, 1e-9);
  EXPECT_FALSE(
      guards.at(section, {0, Mode::open, Mode::clamped}));  // the change leads to sprung, without a damper
}

/// The guard is (K p + d v) / K; its rate uses the acceleration of a sprung contact.
TEST(ScenePlaneGuardMotionSection, AForceThatEndsInUnitsOfLength) {
  SectionGuards guards(driven_mass(5));
  const std::array section{1.2, 0.0, -0.4, 0.0};
  const auto guard = guards.at(section, {0, Mode::sprung, Mode::released});
  ASSERT_TRUE(guard);
  EXPECT_NEAR(guard->value, -(50 * 0.2 - 5 * 0.4) / 50, 1e-14);
  const double acceleration = (3 - 8 * 1.2 - (50 * 0.2 - 5 * 0.4)) / 2;
  EXPECT_NEAR(guard->rate, -(50 * -0.4 + 5 * acceleration) / 50, 1e-14);
}

TEST(ScenePlaneGuardMotionBegunAtPhase, TurnsForceAndImpulses) {
  scene::Scene scene = driven_mass(0);
  scene.impulses.push_back({Eigen::Vector2d(1, 0), 2, 0.25});
  scene.second_harmonic_n = Eigen::Vector2cd(2, 0);
  const scene::Scene later = begun_at_phase(scene, std::numbers::pi / 2);
  EXPECT_NEAR(std::abs(later.second_harmonic_n(0) + 2.0), 0, 1e-15);
  EXPECT_NEAR(std::abs(later.harmonic_n(0) - std::complex<double>(0, 3)), 0, 1e-15);
  // Two impulses per turn, the first one an eighth of a turn after the start: a quarter turn later, the next
  // one comes first.
  EXPECT_NEAR(later.impulses[0].phase_periods, 0.75, 1e-15);
}

/// Example 03 of NLvib with another force amplitude.
std::optional<scene::Scene> driven(double speed, double force) {
  scene::Scene scene = test::two_mass_scene(speed);
  scene.harmonic_n << 0, force;
  return scene;
}

/// Force at which the linear response of the first mass is 1: [k - m, -k; -k, 2 k - m] q = (0, force).
double grazing_force(double w) {
  const std::complex<double> k(1, 0.03 * w), m(w * w, 0);
  return std::abs(((k - m) * (2.0 * k - m) - k * k) / k);
}

class ScenePlaneTwoMass : public ::testing::Test {
 protected:
  ScenePlaneTwoMass() {
    problem_ = scene_orbits([](double speed) { return driven(speed, 0.1); }, 1, {}, modes_);
    problem_.low = 0.4;
    problem_.high = 0.9;
    orbits_ = scene_plane_orbits(driven, 1, {}, modes_);
    orbits_.first = {0.4, 0.9};
    orbits_.second = {0.05, 0.3};
    const auto start = continuation::orbit_from(problem_, Eigen::VectorXd::Zero(4), 0.5);
    if (start) branch_ = continuation::follow(problem_, *start, {});
  }

  std::optional<curves::CurveStart> start_at(continuation::EventKind kind, int which) const {
    for (const continuation::BranchEvent& event : branch_.events) {
      if (event.kind == kind && which-- == 0)
        return curves::curve_start(orbits_, event, {event.point.parameter, 0.1, 0});
    }
    return std::nullopt;
  }

  integrate::exact::modes::ModeCache modes_;
  OrbitProblem problem_;
  PlaneOrbits orbits_;
  continuation::HalfBranch branch_;
};

TEST_F(ScenePlaneTwoMass, GrazesWhereTheLinearResponseReachesTheStop) {
  orbits_.second = {0.005, 0.3};  // range down to the resonance
  const auto first = start_at(continuation::EventKind::graze, 0),
             second = start_at(continuation::EventKind::graze, 1);
  ASSERT_TRUE(first && second);
  EXPECT_NEAR(first->point.place.first, 0.5818996390393, 1e-11);
  EXPECT_NEAR(second->point.place.first, 0.6534401404163, 1e-11);
  const curves::Curve curve = curves::follow_curve(first->system, first->point, {});
  EXPECT_EQ(curve.forward, continuation::Ending::left_range);
  EXPECT_EQ(curve.backward, continuation::Ending::left_range);
  ASSERT_GT(curve.points.size(), 20u);
  for (const curves::CurvePoint& point : curve.points) {
    EXPECT_NEAR(point.place.second / grazing_force(point.place.first), 1, 1e-10) << point.place.first;
    EXPECT_FALSE(point.facts.touched);
    EXPECT_LT(point.critical.curvature, 0);
  }
  EXPECT_TRUE(curves::lies_on(second->system, curve, second->point));
}

const curves::Meeting* find(const curves::Curve& curve, curves::MeetingKind kind) {
  for (const curves::Meeting& meeting : curve.meetings)
    if (meeting.kind == kind) return &meeting;
  return nullptr;
}

/// The critical multiplier is present along the whole curve, and the product of all multipliers follows from
/// the damping. The curves of folds and of doublings agree about their common point.
TEST_F(ScenePlaneTwoMass, FoldsAndDoublings) {
  std::vector<PlanePoint> meetings;
  for (const auto& [kind, critical] : {std::pair{continuation::EventKind::fold, 1.0},
                                       std::pair{continuation::EventKind::period_doubling, -1.0}}) {
    const auto start = start_at(kind, 0);
    ASSERT_TRUE(start);
    const curves::Curve curve = curves::follow_curve(start->system, start->point, {});
    ASSERT_GT(curve.points.size(), 50u);
    for (const curves::CurvePoint& point : curve.points) {
      double nearest = 1;
      for (const std::complex<double> m : point.multipliers)
        nearest = std::min(nearest, std::abs(m - critical));
      EXPECT_LT(nearest, 1e-8) << point.place.first << ' ' << point.place.second;
      const double product = std::exp(-0.09 * 2 * std::numbers::pi / point.place.first);
      EXPECT_NEAR(point.multipliers.prod().real() / product, 1, 1e-8);
      EXPECT_LT(point.error, 1e-10);
    }
    const curves::Meeting* meeting = find(curve, curves::MeetingKind::fold_flip);
    ASSERT_TRUE(meeting);
    meetings.push_back(meeting->point.place);
  }
  EXPECT_NEAR(meetings[0].first, meetings[1].first, 1e-10);
  EXPECT_NEAR(meetings[0].second, meetings[1].second, 1e-10);
}

/// A doubling on the curve is found again by following the speed at another force.
TEST_F(ScenePlaneTwoMass, CurveOfDoublingsAgreesWithABranchAtAnotherForce) {
  const auto start = start_at(continuation::EventKind::period_doubling, 0);
  ASSERT_TRUE(start);
  const curves::Curve curve = curves::follow_curve(start->system, start->point, {});
  const auto other = std::ranges::find_if(curve.points, [](const curves::CurvePoint& point) {
    return point.place.second > 0.11 && point.place.first > 0.73;
  });
  ASSERT_NE(other, curve.points.end());
  OrbitProblem problem =
      scene_orbits([&](double speed) { return driven(speed, other->place.second); }, 1, {}, modes_);
  problem.low = other->place.first - 0.01;
  problem.high = other->place.first + 0.01;
  const auto orbit = continuation::orbit_from(problem, other->state, other->place.first + 1e-5);
  ASSERT_TRUE(orbit);
  const continuation::Branch branch = continuation::follow_both_ways(problem, *orbit, {});
  double nearest = 1;
  for (const continuation::BranchEvent& event : branch.events) {
    if (event.kind == continuation::EventKind::period_doubling)
      nearest = std::min(nearest, std::abs(event.point.parameter - other->place.first));
  }
  EXPECT_LT(nearest, 1e-10);
}

/// Torus bifurcations of the two masses at other forces: the pair stays on the unit circle along the curve.
TEST_F(ScenePlaneTwoMass, Tori) {
  const auto start = start_at(continuation::EventKind::neimark_sacker, 1);
  ASSERT_TRUE(start);
  const curves::Curve curve = curves::follow_curve(start->system, start->point, {});
  ASSERT_GT(curve.points.size(), 20u);
  for (const curves::CurvePoint& point : curve.points) {
    double nearest = 1;
    for (const std::complex<double> m : point.multipliers) {
      if (m.imag() > 0) nearest = std::min(nearest, std::abs(std::abs(m) - 1));
    }
    if (std::abs(point.critical.pair_sum) < 1.999) {
      EXPECT_LT(nearest, 1e-7) << point.place.first;
    }
  }
  EXPECT_TRUE(find(curve, curves::MeetingKind::resonance_1_3) &&
              find(curve, curves::MeetingKind::resonance_1_4));
  EXPECT_TRUE(curve.forward == continuation::Ending::resonance ||
              curve.backward == continuation::Ending::resonance);
}

std::optional<scene::Scene> annular(double speed, double unbalance) {
  return test::annular_scene(1, zeta, speed, unbalance, 0, stiffness, 0);
}

/// Unbalance of a full annular rub with radius r: ((1 + b - w^2) r - b)^2 + (2 zeta w r)^2 = (e w^2)^2. At a
/// fold its derivative with respect to r is zero.
double unbalance_of(double r, double w) {
  return std::hypot((1 + stiffness - w * w) * r - stiffness, 2 * zeta * w * r) / (w * w);
}
double fold_defect(double r, double w) {
  return ((1 + stiffness - w * w) * r - stiffness) * (1 + stiffness - w * w) + 4 * zeta * zeta * w * w * r;
}

/// The quiet circle touches a concentric ring all around when its radius equals the clearance: |1 - W^2 + 2 i
/// zeta W| = e W^2.
TEST(ScenePlane, GrazesOfACircleThatTouchesAllAlong) {
  integrate::exact::modes::ModeCache modes;
  const auto plane = [](double speed, double unbalance) -> std::optional<scene::Scene> {
    return test::annular_scene(1, zeta, speed, unbalance, 0, stiffness, 0.02);
  };
  OrbitProblem problem = scene_orbits([&](double speed) { return plane(speed, 0.4); }, 1, {}, modes);
  problem.low = 0.3;
  problem.high = 3;
  const auto begin = continuation::orbit_from(problem, Eigen::VectorXd::Zero(4), 0.5);
  ASSERT_TRUE(begin);
  const continuation::HalfBranch branch = continuation::follow(problem, *begin, {});
  PlaneOrbits orbits = scene_plane_orbits(plane, 1, {}, modes);
  orbits.first = {0.3, 3};
  orbits.second = {0.3, 0.9};
  int grazes = 0;
  for (const continuation::BranchEvent& event : branch.events) {
    if (event.kind != continuation::EventKind::graze) continue;
    ++grazes;
    const auto start = curves::curve_start(orbits, event, {event.point.parameter, 0.4, 0});
    ASSERT_TRUE(start) << event.point.parameter;
    const curves::Curve curve = curves::follow_curve(start->system, start->point, {});
    EXPECT_EQ(curve.forward, continuation::Ending::left_range);
    EXPECT_EQ(curve.backward, continuation::Ending::left_range);
    EXPECT_TRUE(curve.meetings.empty());
    ASSERT_GT(curve.points.size(), 10u);
    for (const curves::CurvePoint& point : curve.points) {
      const double w = point.place.first;
      EXPECT_NEAR(point.place.second * w * w / std::hypot(1 - w * w, 2 * zeta * w), 1, 1e-9) << w;
      EXPECT_FALSE(point.facts.touched);
    }
  }
  EXPECT_GE(grazes, 1);
}

TEST(ScenePlane, FoldOfTheFullAnnularRub) {
  integrate::exact::modes::ModeCache modes;
  PlaneOrbits orbits = scene_plane_orbits(annular, 1, {}, modes);
  orbits.first = {1.3, 3};
  orbits.second = {0.1, 0.8};
  // Start from a fold in closed form: at w = 2, the radius at which the residual is zero.
  const double w = 2;
  const double a = 1 + stiffness - w * w;
  const double r = stiffness * a / (a * a + 4 * zeta * zeta * w * w);
  ASSERT_NEAR(fold_defect(r, w), 0, 1e-12);
  const double e = unbalance_of(r, w);
  ASSERT_TRUE(orbits.second.holds(e)) << e;
  scene::Scene scene = *annular(w, e);
  const std::complex<double> needed((1 + stiffness - w * w) * r - stiffness, 2 * zeta * w * r);
  const std::complex<double> z = r * std::polar(1.0, -std::arg(needed));
  test::start_at(scene, z, std::complex<double>(0, w) * z);
  const auto section = integrate::run::scaled_initial_state(scene);
  continuation::BranchEvent fold;
  fold.kind = continuation::EventKind::fold;
  fold.point.state = Eigen::Map<const Eigen::VectorXd>(section.data(), 4);
  const auto start = curves::curve_start(orbits, fold, {w, e, 0});
  ASSERT_TRUE(start);
  const curves::Curve curve = curves::follow_curve(start->system, start->point, {});
  EXPECT_EQ(curve.backward, continuation::Ending::left_range);
  EXPECT_EQ(curve.forward, continuation::Ending::left_range);
  ASSERT_GT(curve.points.size(), 20u);
  for (const curves::CurvePoint& point : curve.points) {
    const double at = point.place.first, radius = point.facts.amplitude_m;
    EXPECT_NEAR(point.place.second / unbalance_of(radius, at), 1, 1e-11) << at;
    EXPECT_NEAR(fold_defect(radius, at), 0, 1e-10) << at;
  }
}

}  // namespace

}  // namespace rubsweep::branch::orbits
