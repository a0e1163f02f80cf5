#include "rubsweep/analysis/branch/curves/follow_curve.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <vector>

#include "analysis/branch/curves/cusp_plane.hpp"

namespace rubsweep::branch::curves {
namespace {

using test::cusp_plane;
using test::plain_plane;
using test::plain_plane_of_one_number;

continuation::BranchEvent event_at(continuation::EventKind kind, double state) {
  continuation::BranchEvent event;
  event.kind = kind;
  event.point.state = Eigen::VectorXd::Constant(1, state);
  return event;
}

TEST(FollowCurveCurveStart, FindsTheEventAgain) {
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

TEST(FollowCurveCurveStart, NoneWhereThereIsNoSuchEvent) {
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

/// An orbit at rest at x = p + q, whose guard is x - (phase - 0.3)^2, with its maximum 0.3 rad after the
/// start.
TEST(FollowCurveCurveStart, AGrazeBeginsWhereItTouches) {
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

Eigen::VectorXd number(double x) { return Eigen::VectorXd::Constant(1, x); }

Curve followed(const orbits::PlaneOrbits& orbits, continuation::EventKind kind, const Eigen::VectorXd& state,
               double p, double q, const CurveOptions& options = {}) {
  const auto start = test::start_near(orbits, kind, state, p, q);
  EXPECT_TRUE(start);
  return start ? follow_curve(start->system, start->point, options) : Curve{};
}

const Meeting* find(const Curve& curve, MeetingKind kind) {
  for (const Meeting& meeting : curve.meetings)
    if (meeting.kind == kind) return &meeting;
  return nullptr;
}

TEST(FollowCurve, FoldsThroughACusp) {
  const orbits::PlaneOrbits orbits = cusp_plane();
  const double q = 0.48, x = std::sqrt(q / 3);
  const Curve curve = followed(orbits, continuation::EventKind::fold, number(x), -2 * x * x * x, q);
  ASSERT_EQ(curve.meetings.size(), 1u);
  EXPECT_EQ(curve.meetings[0].kind, MeetingKind::cusp);
  EXPECT_NEAR(curve.meetings[0].point.place.first, 0, 1e-12);
  EXPECT_NEAR(curve.meetings[0].point.place.second, 0, 1e-9);
  EXPECT_EQ(curve.forward, continuation::Ending::left_range);
  EXPECT_EQ(curve.backward, continuation::Ending::left_range);
  EXPECT_NEAR(std::abs(curve.points.front().place.first), 2 * std::pow(3, -1.5), 1e-10);
  EXPECT_LT(curve.points.front().place.first * curve.points.back().place.first, 0);
  EXPECT_EQ(curve.points.back().place.second, 1);
  for (const CurvePoint& point : curve.points) {
    const double r = point.state(0);
    EXPECT_NEAR(point.place.second, 3 * r * r, 1e-10);
    EXPECT_NEAR(point.place.first, -2 * r * r * r, 1e-10);
    EXPECT_NEAR(point.multipliers(0).real(), 1, 1e-10);
    EXPECT_LT(point.error, 1e-10);
  }
  for (std::size_t i = 1; i < curve.points.size(); ++i)
    EXPECT_GT(curve.points[i].arclength, curve.points[i - 1].arclength);
}

/// x -> x + p^2 + q^2 - 1/4 - x^2: the folds form a circle.
TEST(FollowCurve, ACurveThatCloses) {
  const orbits::PlaneOrbits orbits =
      plain_plane_of_one_number([](double p, double q, double x) { return x + p * p + q * q - 0.25 - x * x; },
                                [](double, double, double x) { return 1 - 2 * x; });
  const Curve curve = followed(orbits, continuation::EventKind::fold, number(0), 0.3, 0.4);
  EXPECT_EQ(curve.forward, continuation::Ending::closed);
  EXPECT_EQ(curve.backward, continuation::Ending::closed);
  for (const CurvePoint& point : curve.points)
    EXPECT_NEAR(std::hypot(point.place.first, point.place.second), 0.5, 1e-11);
  EXPECT_NEAR(curve.points.back().arclength, std::numbers::pi / 2,
              3e-3);  // half of the lengths, because the ranges have width 2
  const auto again = test::start_near(orbits, continuation::EventKind::fold, number(0), -0.5, 0);
  ASSERT_TRUE(again);
  EXPECT_TRUE(lies_on(again->system, curve, again->point));
}

/// x -> -(1 + p) x + q x^3 + x^5: the origin doubles its period at p = 0, supercritically on one side of q =
/// 0.
TEST(FollowCurve, DoublingsThroughAGeneralisedFlip) {
  const orbits::PlaneOrbits orbits = plain_plane_of_one_number(
      [](double p, double q, double x) { return -(1 + p) * x + q * x * x * x + std::pow(x, 5); },
      [](double p, double q, double x) { return -(1 + p) + 3 * q * x * x + 5 * std::pow(x, 4); });
  const Curve curve = followed(orbits, continuation::EventKind::period_doubling, number(0), 0, 0.3);
  ASSERT_EQ(curve.meetings.size(), 1u);
  EXPECT_EQ(curve.meetings[0].kind, MeetingKind::generalised_flip);
  EXPECT_NEAR(curve.meetings[0].point.place.second, 0, 1e-6);
  for (const CurvePoint& point : curve.points) EXPECT_NEAR(point.place.first, 0, 1e-11);
}

/// z -> (1 + p) e^{i pi (q + 1) / 2} z: the origin has torus bifurcations at p = 0 for every angle between 0
/// and 180 degrees, where the curve ends.
TEST(FollowCurve, ToriThroughResonances) {
  const auto turn = [](double p, double q) {
    const double angle = std::numbers::pi * (q + 1.0) / 2;
    return Eigen::Matrix2d((1 + p) * Eigen::Rotation2Dd(angle).toRotationMatrix());
  };
  orbits::PlaneOrbits orbits = plain_plane(
      [turn](double p, double q, const Eigen::VectorXd& x) { return Eigen::VectorXd(turn(p, q) * x); },
      [turn](double p, double q, const Eigen::VectorXd&) { return Eigen::MatrixXd(turn(p, q)); });
  const Curve curve =
      followed(orbits, continuation::EventKind::neimark_sacker, Eigen::Vector2d::Zero(), 0, -0.6);
  const Meeting *third = find(curve, MeetingKind::resonance_1_3),
                *fourth = find(curve, MeetingKind::resonance_1_4);
  ASSERT_TRUE(third && fourth);
  EXPECT_NEAR(third->point.place.second, 1.0 / 3, 1e-11);
  EXPECT_NEAR(fourth->point.place.second, 0, 1e-11);
  for (const CurvePoint& point : curve.points) EXPECT_NEAR(point.place.first, 0, 1e-11);
}

/// y -> (1 + p) y + q - x^2, x -> x + new y: fixed points x = +-sqrt(q), whose multipliers have the sum 2 + p
/// - 2 x and the product 1 + p.
orbits::PlaneOrbits bogdanov_takens_plane() {
  return plain_plane(
      [](double p, double q, const Eigen::VectorXd& x) {
        const double y = (1 + p) * x(1) + q - x(0) * x(0);
        return Eigen::VectorXd(Eigen::Vector2d(x(0) + y, y));
      },
      [](double p, double, const Eigen::VectorXd& x) {
        return Eigen::MatrixXd((Eigen::Matrix2d() << 1 - 2 * x(0), 1 + p, -2 * x(0), 1 + p).finished());
      });
}

/// Torus bifurcations at p = 0, from the 1:1 resonance at q = 0 to the 1:2 resonance at x = 2.
TEST(FollowCurve, ToriEndWhereTheirMultipliersAreReal) {
  orbits::PlaneOrbits orbits = bogdanov_takens_plane();
  orbits.second = {-1, 5};
  const Curve curve =
      followed(orbits, continuation::EventKind::neimark_sacker, Eigen::Vector2d(0.5, 0), 0, 0.25);
  EXPECT_EQ(curve.forward, continuation::Ending::resonance);
  EXPECT_EQ(curve.backward, continuation::Ending::resonance);
  ASSERT_EQ(curve.meetings.size(), 4u);
  for (const auto& [kind, q] :
       {std::pair{MeetingKind::resonance_1_1, 0.0}, std::pair{MeetingKind::resonance_1_2, 4.0},
        std::pair{MeetingKind::resonance_1_3, 2.25}, std::pair{MeetingKind::resonance_1_4, 1.0}}) {
    const Meeting* meeting = find(curve, kind);
    ASSERT_TRUE(meeting) << to_string(kind);
    EXPECT_NEAR(meeting->point.place.second, q, 1e-10);
  }
  for (const CurvePoint& point : curve.points) EXPECT_NEAR(point.place.first, 0, 1e-11);
}

/// x -> (1 + p + q) x - x^3: symmetry breaks on the line p + q = 0.
TEST(FollowCurve, BreaksOfSymmetry) {
  const orbits::PlaneOrbits orbits =
      plain_plane_of_one_number([](double p, double q, double x) { return (1 + p + q) * x - x * x * x; },
                                [](double p, double q, double x) { return 1 + p + q - 3 * x * x; });
  const Curve curve = followed(orbits, continuation::EventKind::branch_point, number(0), -0.2, 0.2);
  EXPECT_EQ(curve.forward, continuation::Ending::left_range);
  EXPECT_EQ(curve.backward, continuation::Ending::left_range);
  EXPECT_TRUE(curve.meetings.empty());
  for (const CurvePoint& point : curve.points) {
    EXPECT_NEAR(point.place.first, -point.place.second, 1e-11);
    EXPECT_NEAR(point.state(0), 0, 1e-9);
  }
}

/// x -> (1 + p) x - x^3 + q: the branches cross at q = 0 only.
TEST(FollowCurve, ACrossingWithoutSymmetryUnfolds) {
  const orbits::PlaneOrbits orbits =
      plain_plane_of_one_number([](double p, double q, double x) { return (1 + p) * x - x * x * x + q; },
                                [](double p, double, double x) { return 1 + p - 3 * x * x; });
  const Curve curve = followed(orbits, continuation::EventKind::branch_point, number(0), 0, 0);
  EXPECT_EQ(curve.forward, continuation::Ending::unfolds);
  EXPECT_EQ(curve.backward, continuation::Ending::unfolds);
}

/// A fold in x at p = 0, and a multiplier -1 - p - q of y.
TEST(FollowCurve, FoldAndFlip) {
  const orbits::PlaneOrbits orbits = plain_plane(
      [](double p, double q, const Eigen::VectorXd& x) {
        return Eigen::VectorXd(Eigen::Vector2d(x(0) + p - x(0) * x(0), -(1 + p + q) * x(1)));
      },
      [](double p, double q, const Eigen::VectorXd& x) {
        return Eigen::MatrixXd(Eigen::Vector2d(1 - 2 * x(0), -(1 + p + q)).asDiagonal());
      });
  const Curve curve = followed(orbits, continuation::EventKind::fold, Eigen::Vector2d::Zero(), 0, 0.4);
  ASSERT_EQ(curve.meetings.size(), 1u);
  EXPECT_EQ(curve.meetings[0].kind, MeetingKind::fold_flip);
  EXPECT_NEAR(curve.meetings[0].point.place.second, 0, 1e-11);
  const Curve flips =
      followed(orbits, continuation::EventKind::period_doubling, Eigen::Vector2d(0.5, 0), 0.25, -0.25);
  const Meeting* same = find(flips, MeetingKind::fold_flip);
  ASSERT_TRUE(same);
  EXPECT_NEAR(same->point.place.first, 0, 1e-11);
}

/// Folds at q = 0 with the multipliers 1 and 1 + p.
TEST(FollowCurve, FoldWithTwoMultipliersOne) {
  const orbits::PlaneOrbits exchanged = test::exchanged(bogdanov_takens_plane());
  const Curve curve = followed(exchanged, continuation::EventKind::fold, Eigen::Vector2d::Zero(), 0, 0.4);
  ASSERT_EQ(curve.meetings.size(), 1u);
  EXPECT_EQ(curve.meetings[0].kind, MeetingKind::resonance_1_1);
  EXPECT_NEAR(curve.meetings[0].point.place.second, 0, 1e-10);
}

TEST(FollowCurve, EndsWhereThereIsNoMachineOrTheSolverFails) {
  for (const auto& [evaluation, ending] :
       {std::pair{orbits::Evaluation::infeasible, continuation::Ending::infeasible},
        std::pair{orbits::Evaluation::failed, continuation::Ending::failed}}) {
    orbits::PlaneOrbits orbits = cusp_plane();
    orbits.returns = [map = orbits.returns, evaluation = evaluation](
                         const orbits::PlanePoint& at, Eigen::VectorXd& x, Eigen::MatrixXd* monodromy) {
      return at.second > 0.8 ? evaluation : map(at, x, monodromy);
    };
    const double q = 0.48, x = std::sqrt(q / 3);
    const Curve curve = followed(orbits, continuation::EventKind::fold, number(x), -2 * x * x * x, q);
    EXPECT_EQ(curve.forward, ending);
    EXPECT_EQ(curve.backward, ending);
    EXPECT_NEAR(curve.points.back().place.second, 0.8, 1e-4);
  }
}

TEST(FollowCurve, EndsAtTheLimitOfPoints) {
  CurveOptions few;
  few.most_points = 5;
  const double q = 0.48, x = std::sqrt(q / 3);
  const Curve curve =
      followed(cusp_plane(), continuation::EventKind::fold, number(x), -2 * x * x * x, q, few);
  EXPECT_EQ(curve.forward, continuation::Ending::point_limit);
  EXPECT_EQ(curve.points.size(), 9u);
}

}  // namespace
}  // namespace rubsweep::branch::curves
