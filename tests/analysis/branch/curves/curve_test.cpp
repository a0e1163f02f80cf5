#include "rubsweep/analysis/branch/curves/curve.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "analysis/branch/curves/cusp_plane.hpp"
#include "rubsweep/analysis/branch/continuation/segment.hpp"

namespace rubsweep::branch::curves {
namespace {

TEST(CurveNewton, FindsTheFoldOnAPlane) {
  const test::FoldsOfACusp folds;
  continuation::Position guess = folds.at(0.4);
  guess += continuation::Position::Constant(3, 1e-3);
  continuation::Position direction = continuation::Position::Zero(3);
  direction(2) = 1;  // q stays constant
  const CurveCorrection found = correct(folds.system, guess, direction);
  ASSERT_TRUE(found.converged);
  EXPECT_LE(found.error, 1e-11);
  const orbits::PlanePoint place = place_of(folds.system, found.at);
  EXPECT_NEAR(place.second, 0.48 + 2e-3, 1e-15);
  EXPECT_NEAR(27 * place.first * place.first, 4 * std::pow(place.second, 3), 1e-11);
}

/// Folds (x, p, q) = (r, -2 r^3, 3 r^2); parameters are scaled by ranges of width 2.
TEST(CurveNewton, TangentAndFactsOfAPoint) {
  const test::FoldsOfACusp folds;
  const auto point = folds.point(0.4);
  ASSERT_TRUE(point);
  const continuation::Position along = Eigen::Vector3d(1, -3 * 0.16, 3 * 0.4).normalized();
  EXPECT_NEAR(std::abs(point->tangent.dot(along)), 1, 1e-10);
  EXPECT_GT(point->tangent(0), 0) << "on the side of the direction";
  EXPECT_NEAR(point->multipliers(0).real(), 1, 1e-10);
  EXPECT_NEAR(std::abs(point->critical.quadratic), 6 * 0.4, 1e-8);
}

TEST(CurveNewton, ASegmentBetweenItsEnds) {
  const test::FoldsOfACusp folds;
  const auto from = folds.point(0.3), to = folds.point(0.4);
  ASSERT_TRUE(from && to);
  const continuation::Segment segment(folds.system, *from, *to);
  EXPECT_NEAR(segment.length(), from->tangent.dot(to->at - from->at), 1e-15);
  const auto middle = segment.at(segment.length() / 2);
  ASSERT_TRUE(middle);
  EXPECT_NEAR(from->tangent.dot(middle->at - from->at), segment.length() / 2, 1e-10);
  const double r = middle->state(0);
  EXPECT_GT(r, 0.3);
  EXPECT_LT(r, 0.4);
  EXPECT_NEAR(middle->place.second, 3 * r * r, 1e-10);
  EXPECT_EQ(segment.at(0)->at, from->at);
  EXPECT_EQ(segment.at(2 * segment.length())->at, to->at);
}

/// The three equations of a cusp cannot be solved on a plane along the state only.
TEST(CurveNewton, NothingToFind) {
  const test::FoldsOfACusp folds;
  continuation::Position direction = continuation::Position::Zero(3);
  direction(1) = 1;
  EXPECT_TRUE(correct(folds.system, folds.at(0), direction).singular) << "p stays, and x may be anything";
  orbits::PlaneOrbits nowhere = test::cusp_plane();
  nowhere.returns = [](const orbits::PlanePoint&, Eigen::VectorXd&, Eigen::MatrixXd*) {
    return orbits::Evaluation::failed;
  };
  const ExtendedSystem system{&nowhere, continuation::EventKind::fold, 1};
  const CurveCorrection failed = correct(system, folds.at(0.4), direction);
  EXPECT_EQ(failed.evaluation, orbits::Evaluation::failed);
  EXPECT_FALSE(failed.converged);
}

}  // namespace

}  // namespace rubsweep::branch::curves
