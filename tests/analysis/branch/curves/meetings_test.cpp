#include "rubsweep/analysis/branch/curves/meetings.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "analysis/branch/curves/cusp_plane.hpp"
#include "rubsweep/analysis/branch/curves/follow_curve.hpp"

namespace rubsweep::branch::curves {
namespace {

TEST(Meetings, ACuspOnAStepOverIt) {
  const test::FoldsOfACusp folds;
  const auto before = folds.point(-0.03), behind = folds.point(0.05), farther = folds.point(0.1);
  ASSERT_TRUE(before && behind && farther);
  const auto meetings = meetings_between(folds.system, *before, *behind);
  ASSERT_TRUE(meetings);
  ASSERT_EQ(meetings->size(), 1u);
  EXPECT_EQ(meetings->front().kind, MeetingKind::cusp);
  EXPECT_NEAR(meetings->front().point.state(0), 0, 1e-9);
  EXPECT_LE(meetings->front().error, 1e-12);
  EXPECT_TRUE(meetings_between(folds.system, *behind, *farther)->empty());
  EXPECT_FALSE(meetings_between(folds.system, *behind, *before)) << "the tangent leads the other way";
}

/// A change of the contact sequence at q = 0.12 is found with the same accuracy, and is named after the
/// curve.
TEST(Meetings, AGrazeOnACurveOfFolds) {
  test::FoldsOfACusp folds;
  folds.orbits.facts = [](const orbits::PlanePoint& at, const Eigen::VectorXd&) {
    orbits::OrbitFacts facts;
    if (at.second > 0.12)
      facts.switches = {{1, 0, contact::Mode::open, contact::Mode::sprung},
                        {1.1, 0, contact::Mode::sprung, contact::Mode::open}};
    return std::optional(facts);
  };
  const auto from = folds.point(0.15), to = folds.point(0.25);
  ASSERT_TRUE(from && to);
  const auto meetings = meetings_between(folds.system, *from, *to);
  ASSERT_TRUE(meetings);
  ASSERT_EQ(meetings->size(), 1u);
  EXPECT_EQ(meetings->front().kind, MeetingKind::graze_fold);
  EXPECT_NEAR(meetings->front().point.place.second, 0.12, 1e-11);
  EXPECT_NEAR(meetings->front().point.state(0), 0.2, 1e-11);
}

/// z -> (1 + p) e^{i pi (q + 1) / 2} z has torus bifurcations at p = 0, with the angle 90 degrees at q = 0
/// and 120 degrees at q = 1/3.
TEST(Meetings, TwoResonancesInOneStepInTheirOrder) {
  const auto turn = [](double p, double q) {
    const double angle = std::numbers::pi * (q + 1) / 2;
    return Eigen::Matrix2d((1 + p) * Eigen::Rotation2Dd(angle).toRotationMatrix());
  };
  const orbits::PlaneOrbits orbits = test::plain_plane(
      [turn](double p, double q, const Eigen::VectorXd& x) { return Eigen::VectorXd(turn(p, q) * x); },
      [turn](double p, double q, const Eigen::VectorXd&) { return Eigen::MatrixXd(turn(p, q)); });
  const ExtendedSystem system{&orbits, continuation::EventKind::neimark_sacker, 2};
  continuation::Position direction = continuation::Position::Zero(4);
  direction(3) = 1;
  const auto point_at = [&](double q) {
    const CurveCorrection found =
        correct(system, position_of(system, {0, q, 0}, Eigen::Vector2d::Zero()), direction);
    return completed(system, found, direction, q);
  };
  const auto from = point_at(-0.2), to = point_at(0.5);
  ASSERT_TRUE(from && to);
  const auto meetings = meetings_between(system, *from, *to);
  ASSERT_TRUE(meetings);
  ASSERT_EQ(meetings->size(), 2u);
  EXPECT_EQ((*meetings)[0].kind, MeetingKind::resonance_1_4);
  EXPECT_NEAR((*meetings)[0].point.place.second, 0, 1e-11);
  EXPECT_EQ((*meetings)[1].kind, MeetingKind::resonance_1_3);
  EXPECT_NEAR((*meetings)[1].point.place.second, 1.0 / 3, 1e-11);
}

/// Distance from the line q = 0 at which the curves of the normal forms below are started.
constexpr double beside = 0.3;

/// Expects exactly one meeting on the curve, of `kind` and at the origin of the plane.
void expect_one_at_the_origin(const std::optional<CurveStart>& start, MeetingKind kind, double within) {
  ASSERT_TRUE(start);
  const Curve curve = follow_curve(start->system, start->point, {});
  EXPECT_EQ(curve.forward, continuation::Ending::left_range);
  EXPECT_EQ(curve.backward, continuation::Ending::left_range);
  ASSERT_EQ(curve.meetings.size(), 1u) << to_string(kind);
  EXPECT_EQ(curve.meetings[0].kind, kind) << to_string(curve.meetings[0].kind);
  EXPECT_NEAR(curve.meetings[0].point.place.first, 0, within);
  EXPECT_NEAR(curve.meetings[0].point.place.second, 0, within);
}

Eigen::Matrix2d rotation(double angle_rad) { return Eigen::Rotation2Dd(angle_rad).toRotationMatrix(); }

/// Maps of one number x together with a rotation of two numbers by `angle_rad`, which grows by the factor 1 +
/// p + q.
template <class Map, class Slope>
orbits::PlaneOrbits beside_a_rotation(const Map& map, const Slope& slope, double angle_rad) {
  const auto turn = [angle_rad](double p, double q) {
    return Eigen::Matrix2d((1 + p + q) * rotation(angle_rad));
  };
  return test::plain_plane(
      [=](double p, double q, const Eigen::VectorXd& x) {
        Eigen::VectorXd image(3);
        image << map(p, x(0)), turn(p, q) * x.tail(2);
        return image;
      },
      [=](double p, double q, const Eigen::VectorXd& x) {
        Eigen::MatrixXd slopes = Eigen::MatrixXd::Zero(3, 3);
        slopes(0, 0) = slope(p, x(0));
        slopes.bottomRightCorner(2, 2) = turn(p, q);
        return slopes;
      });
}

/// x -> (1 + p) x + q x^3 - x^5: the symmetry breaks at p = 0, supercritically for q < 0.
TEST(Meetings, DegenerateBranching) {
  const orbits::PlaneOrbits orbits = test::plain_plane_of_one_number(
      [](double p, double q, double x) { return (1 + p) * x + q * x * x * x - std::pow(x, 5); },
      [](double p, double q, double x) { return 1 + p + 3 * q * x * x - 5 * std::pow(x, 4); });
  expect_one_at_the_origin(
      test::start_near(orbits, continuation::EventKind::branch_point, Eigen::VectorXd::Zero(1), 0, beside),
      MeetingKind::degenerate_branching, 1e-6);
}

/// Folds at p = 0 and torus bifurcations at q = -p for p > 0.
TEST(Meetings, FoldAndTorus) {
  const orbits::PlaneOrbits orbits = beside_a_rotation([](double p, double x) { return x + p - x * x; },
                                                       [](double, double x) { return 1 - 2 * x; }, 2);
  expect_one_at_the_origin(
      test::start_near(orbits, continuation::EventKind::fold, Eigen::Vector3d::Zero(), 0, beside),
      MeetingKind::fold_torus, 1e-10);
}

/// Period doublings at p = 0 and torus bifurcations at q = -p.
TEST(Meetings, FlipAndTorus) {
  const orbits::PlaneOrbits orbits =
      beside_a_rotation([](double p, double x) { return -(1 + p) * x + x * x * x; },
                        [](double p, double x) { return -(1 + p) + 3 * x * x; }, 2);
  for (const continuation::EventKind kind :
       {continuation::EventKind::period_doubling, continuation::EventKind::neimark_sacker}) {
    const double p = kind == continuation::EventKind::period_doubling ? 0 : -beside;
    expect_one_at_the_origin(test::start_near(orbits, kind, Eigen::Vector3d::Zero(), p, beside),
                             MeetingKind::flip_torus, 1e-10);
  }
}

/// Period doublings at p = 0 and at p = -q.
TEST(Meetings, TwoDoublings) {
  const orbits::PlaneOrbits orbits = test::plain_plane(
      [](double p, double q, const Eigen::VectorXd& x) {
        return Eigen::VectorXd(Eigen::Vector2d(-(1 + p) * x(0), -(1 + p + q) * x(1)));
      },
      [](double p, double q, const Eigen::VectorXd&) {
        return Eigen::MatrixXd(Eigen::Vector2d(-(1 + p), -(1 + p + q)).asDiagonal());
      });
  expect_one_at_the_origin(
      test::start_near(orbits, continuation::EventKind::period_doubling, Eigen::Vector2d::Zero(), 0, beside),
      MeetingKind::resonance_1_2, 1e-10);
}

/// Torus bifurcations at p = 0 with the angle 1 rad, and at q = -p with 2 rad.
TEST(Meetings, TwoTori) {
  const auto both = [](double p, double q) {
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(4, 4);
    matrix.topLeftCorner(2, 2) = (1 + p) * rotation(1);
    matrix.bottomRightCorner(2, 2) = (1 + p + q) * rotation(2);
    return matrix;
  };
  const orbits::PlaneOrbits orbits = test::plain_plane(
      [both](double p, double q, const Eigen::VectorXd& x) { return Eigen::VectorXd(both(p, q) * x); },
      [both](double p, double q, const Eigen::VectorXd&) { return both(p, q); });
  expect_one_at_the_origin(
      test::start_near(orbits, continuation::EventKind::neimark_sacker, Eigen::Vector4d::Zero(), 0, beside),
      MeetingKind::double_torus, 1e-10);
}

/// A linear map `matrix(p, q)` with the orbit 0 and the guard p - phase^2: it grazes at p = 0.
template <class Matrix>
orbits::PlaneOrbits grazing(const Matrix& matrix) {
  orbits::PlaneOrbits orbits = test::plain_plane(
      [matrix](double p, double q, const Eigen::VectorXd& x) { return Eigen::VectorXd(matrix(p, q) * x); },
      [matrix](double p, double q, const Eigen::VectorXd&) { return Eigen::MatrixXd(matrix(p, q)); });
  orbits.guard = [](const orbits::PlanePoint& at, const Eigen::VectorXd&, const orbits::ArmedGuard&) {
    return std::optional(orbits::GuardMotion{at.first - at.phase_rad * at.phase_rad, -2 * at.phase_rad, -2});
  };
  orbits.at_phase = [](const orbits::PlanePoint&, const Eigen::VectorXd& x, double&) {
    return std::optional(x);
  };
  return orbits;
}

std::optional<CurveStart> graze_near(const orbits::PlaneOrbits& orbits, const Eigen::VectorXd& state,
                                     const orbits::PlanePoint& place) {
  continuation::BranchEvent event;
  event.kind = continuation::EventKind::graze;
  event.point.state = state;
  event.change = orbits::SequenceChange{};
  event.change->middle_rad = place.phase_rad;
  return curve_start(orbits, event, place);
}

TEST(Meetings, OfGrazesWithMultipliersOnTheUnitCircle) {
  const auto flip = [](double, double q) {
    return Eigen::Matrix2d(Eigen::Vector2d(-1 - q, 0.3).asDiagonal());
  };
  const auto torus = [](double, double q) { return Eigen::Matrix2d((1 + q) * rotation(2)); };
  const orbits::PlanePoint place{0, beside, 0};
  expect_one_at_the_origin(graze_near(grazing(flip), Eigen::Vector2d::Zero(), place), MeetingKind::graze_flip,
                           1e-10);
  expect_one_at_the_origin(graze_near(grazing(torus), Eigen::Vector2d::Zero(), place),
                           MeetingKind::graze_torus, 1e-10);
}

/// x -> x + p - x^2 with the guard x - q - phase^2 grazes at p = q^2, where the multiplier is 1 - 2 q.
TEST(Meetings, AGrazeAtAFold) {
  orbits::PlaneOrbits orbits =
      test::plain_plane_of_one_number([](double p, double, double x) { return x + p - x * x; },
                                      [](double, double, double x) { return 1 - 2 * x; });
  orbits.guard = [](const orbits::PlanePoint& at, const Eigen::VectorXd& x, const orbits::ArmedGuard&) {
    return std::optional(
        orbits::GuardMotion{x(0) - at.second - at.phase_rad * at.phase_rad, -2 * at.phase_rad, -2});
  };
  orbits.at_phase = [](const orbits::PlanePoint&, const Eigen::VectorXd& x, double&) {
    return std::optional(x);
  };
  expect_one_at_the_origin(
      graze_near(orbits, Eigen::VectorXd::Constant(1, beside), {beside * beside, beside, 0}),
      MeetingKind::graze_fold, 1e-10);
}

/// A second contact is touched where q > 0.
TEST(Meetings, TwoGrazesAtOnce) {
  orbits::PlaneOrbits orbits = grazing([](double, double) { return Eigen::Matrix2d(0.5 * rotation(1)); });
  orbits.facts = [](const orbits::PlanePoint& at, const Eigen::VectorXd&) {
    orbits::OrbitFacts facts;
    if (at.second > 0)
      facts.switches = {{1, 1, contact::Mode::open, contact::Mode::sprung},
                        {1.1, 1, contact::Mode::sprung, contact::Mode::open}};
    return std::optional(facts);
  };
  expect_one_at_the_origin(graze_near(orbits, Eigen::Vector2d::Zero(), {0, beside, 0}),
                           MeetingKind::double_graze, 1e-10);
}

/// The guard p + q phase + phase^3 / 3 grazes along q = -phase^2, p = 2 phase^3 / 3, with the second
/// derivative 2 phase: beyond the cusp of this curve the guard only rises.
TEST(Meetings, AGrazeThatDoesNotTurnBack) {
  orbits::PlaneOrbits orbits = grazing([](double, double) { return Eigen::Matrix2d(0.5 * rotation(1)); });
  orbits.guard = [](const orbits::PlanePoint& at, const Eigen::VectorXd&, const orbits::ArmedGuard&) {
    const double t = at.phase_rad;
    return std::optional(
        orbits::GuardMotion{at.first + at.second * t + t * t * t / 3, at.second + t * t, 2 * t});
  };
  const double phase = std::sqrt(beside);
  expect_one_at_the_origin(
      graze_near(orbits, Eigen::Vector2d::Zero(), {2 * phase * phase * phase / 3, -beside, phase}),
      MeetingKind::degenerate_graze, 1e-10);
}

}  // namespace
}  // namespace rubsweep::branch::curves
