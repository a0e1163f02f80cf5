#include "rubsweep/analysis/branch/curves/curve_start.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/branch/curves/cusp_plane.hpp"

namespace rubsweep::branch::curves {
namespace {

continuation::BranchEvent event_at(continuation::EventKind kind, double state) {
  continuation::BranchEvent event;
  event.kind = kind;
  event.point.state = Eigen::VectorXd::Constant(1, state);
  return event;
}

TEST(CurveStart, FindsTheEventAgain) {
  const orbits::PlaneOrbits orbits = test::cusp_plane();
  const double r = 0.4;
  const auto start =
      curve_start(orbits, event_at(continuation::EventKind::fold, r + 1e-7), {-2 * r * r * r, 3 * r * r, 0});
  ASSERT_TRUE(start);
  EXPECT_EQ(start->system.kind, continuation::EventKind::fold);
  EXPECT_EQ(start->system.orbits, &orbits);
  EXPECT_NEAR(start->point.state(0), r, 1e-10);
  EXPECT_EQ(start->point.place.second, 3 * r * r);
  EXPECT_EQ(start->point.arclength, 0);
}

TEST(CurveStart, NoneWhereThereIsNoSuchEvent) {
  const orbits::PlaneOrbits orbits = test::cusp_plane();
  const double r = 0.4;
  const orbits::PlanePoint beside{-2 * r * r * r + 1e-3, 3 * r * r, 0};
  EXPECT_FALSE(curve_start(orbits, event_at(continuation::EventKind::fold, r), beside))
      << "a fold, but elsewhere";
  const orbits::PlanePoint there{-2 * r * r * r, 3 * r * r, 0};
  for (const continuation::EventKind kind :
       {continuation::EventKind::period_halving, continuation::EventKind::sequence,
        continuation::EventKind::stability})
    EXPECT_FALSE(curve_start(orbits, event_at(kind, r), there)) << to_string(kind);
}

/// An orbit at rest at x = p + q whose guard, 0.3 rad after its start, is x - (phase - 0.3)^2.
TEST(CurveStart, AGrazeBeginsWhereItTouches) {
  orbits::PlaneOrbits orbits =
      test::plain_plane_of_one_number([](double p, double q, double x) { return 0.5 * (x + p + q); },
                                      [](double, double, double) { return 0.5; });
  orbits.guard = [](const orbits::PlanePoint& at, const Eigen::VectorXd& x,
                    const orbits::ArmedGuard& guard) -> std::optional<orbits::GuardMotion> {
    if (guard.contact != 2) return std::nullopt;
    const double phase = at.phase_rad - 0.3;
    return orbits::GuardMotion{x(0) - phase * phase, -2 * phase, -2};
  };
  continuation::BranchEvent event = event_at(continuation::EventKind::graze, 0);
  EXPECT_FALSE(curve_start(orbits, event, {0.2, -0.2, 0})) << "it is not known what grazes";
  event.change = orbits::SequenceChange{.contact = 2, .middle_rad = 0.3001};
  EXPECT_FALSE(curve_start(orbits, event, {0.2, -0.2, 0})) << "nobody knows the state at a phase";
  orbits.at_phase = [](const orbits::PlanePoint&, const Eigen::VectorXd& state, double&) {
    return std::optional(state);
  };
  const auto start = curve_start(orbits, event, {0.2, -0.2, 0});
  ASSERT_TRUE(start);
  EXPECT_EQ(start->system.guard.contact, 2);
  EXPECT_NEAR(start->point.place.phase_rad, 0.3, 1e-9);
  EXPECT_NEAR(start->point.place.first, 0.2, 1e-10);
}

}  // namespace
}  // namespace rubsweep::branch::curves
