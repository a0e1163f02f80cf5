// Tangent vectors of a series against differences of series that begin beside it.
#include "rubsweep/core/integrate/taylor/regular_tangents.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "core/integrate/taylor/power_contact.hpp"
#include "rubsweep/core/integrate/taylor/series_options.hpp"

namespace rubsweep::integrate::taylor {
namespace {

constexpr double speed = 0.8;

/// State after `advance_rad` of a motion that begins with a change of coordinate `which`, or of the damping
/// if there is none.
Eigen::VectorXd moved(const PowerContactCase& each, std::vector<double> state, std::size_t which, double by,
                      double advance_rad) {
  PowerContact<4> at(each);
  if (which < 8)
    state[which] += by;
  else
    at.damp(1 / (1 / speed + by));
  RegularExpansion<4> motion(at.system, rounding_of_series);
  EXPECT_TRUE(at.expand(motion, state));
  Eigen::VectorXd end(8);
  motion.put_state(motion.time().parameter_at(advance_rad, motion.converged()), end.data());
  return end;
}

TEST(RegularTangents, AreDerivativesOfTheMotionAtTheSamePhase) {
  for (const PowerContactCase& each : power_contact_cases()) {
    for (const double penetration : {0.02, 0.3}) {
      const std::vector<double> state = PowerContact<4>::state(penetration, 0.7);
      PowerContact<4> at(each);
      RegularExpansion<4> motion(at.system, rounding_of_series);
      ASSERT_TRUE(at.expand(motion, state));
      const double s = motion.converged() / 2, advance_rad = motion.time().phase_after(s);
      Eigen::MatrixXd vectors = Eigen::MatrixXd::Zero(9, 9);
      vectors.topLeftCorner(8, 8).setIdentity();
      vectors(8, 8) = at.law.impact_damping(0) * speed;  // d c / d (1 / speed)
      RegularTangents<4> tangents(at.system);
      ASSERT_TRUE(tangents.pass(motion, s, 1e-13, {0}, Eigen::Map<Eigen::MatrixXd>(vectors.data(), 9, 9)));
      EXPECT_EQ(vectors(8, 8), at.law.impact_damping(0) * speed);
      for (std::size_t which = 0; which < 9; ++which) {
        const auto slope = [&](double h) -> Eigen::VectorXd {
          return (moved(each, state, which, h, advance_rad) - moved(each, state, which, -h, advance_rad)) /
                 (2 * h);
        };
        const Eigen::VectorXd expected = (4 * slope(1e-4) - slope(2e-4)) / 3;
        const auto found = vectors.col(Eigen::Index(which)).head(8);
        EXPECT_LT((found - expected).cwiseAbs().maxCoeff(),
                  1e-7 * std::max(1.0, expected.cwiseAbs().maxCoeff()))
            << each.exponent << " " << each.annular << " " << penetration << " " << which;
      }
    }
  }
}

TEST(RegularTangents, AreThoseOfAnyNumberOfCoordinates) {
  for (const PowerContactCase& each : power_contact_cases()) {
    const std::vector<double> state = PowerContact<4>::state(0.02, 0.7);
    PowerContact<4> at(each);
    PowerContact<Eigen::Dynamic> other(each);
    RegularExpansion<4> motion(at.system, rounding_of_series);
    RegularExpansion<Eigen::Dynamic> same(other.system, rounding_of_series);
    ASSERT_TRUE(at.expand(motion, state));
    ASSERT_TRUE(other.expand(same, state));
    const double s = motion.converged() / 2;
    Eigen::MatrixXd a = Eigen::MatrixXd::Identity(8, 3), b = a;
    ASSERT_TRUE(RegularTangents<4>(at.system).pass(motion, s, 1e-13, {},
                                                   Eigen::Map<Eigen::MatrixXd>(a.data(), 8, 3)));
    ASSERT_TRUE(RegularTangents<Eigen::Dynamic>(other.system)
                    .pass(same, s, 1e-13, {}, Eigen::Map<Eigen::MatrixXd>(b.data(), 8, 3)));
    EXPECT_LT((a - b).cwiseAbs().maxCoeff(), 1e-13 * a.cwiseAbs().maxCoeff());
  }
}

/// From the instant of touching, several successive terms are zero before the others come: no accuracy may
/// take them for the end of the series.
TEST(RegularTangents, ZeroTermsAfterTheTouchingEndNoSeries) {
  for (PowerContactCase each : power_contact_cases()) {
    if (each.mode != contact::Mode::sprung) continue;
    each.harder = 1e6;
    PowerContact<4> at(each);
    RegularExpansion<4> motion(at.system, rounding_of_series);
    ASSERT_TRUE(at.expand(motion, PowerContact<4>::state(0, 0.7)));
    RegularTangents<4> tangents(at.system);
    int compared = 0;
    for (const double share : {0.02, 0.05, 0.1, 0.2, 0.3}) {
      const double s = share * motion.converged();
      Eigen::MatrixXd closest, found;
      const auto moves = [&](double accuracy, Eigen::MatrixXd& vectors) {
        vectors = Eigen::MatrixXd::Identity(8, 8);
        return tangents.pass(motion, s, accuracy, {}, Eigen::Map<Eigen::MatrixXd>(vectors.data(), 8, 8));
      };
      if (!moves(1e-13, closest)) continue;
      ++compared;
      for (double accuracy = 1e-2; accuracy > 1e-11; accuracy /= 4) {
        ASSERT_TRUE(moves(accuracy, found));
        for (int column = 0; column < 8; ++column)
          for (const int half : {0, 4}) {
            const auto expected = closest.col(column).segment(half, 4);
            const double error = (found.col(column).segment(half, 4) - expected).norm();
            EXPECT_LT(error, 10 * accuracy * std::max(1e-2, expected.norm()))
                << each.exponent << " " << each.annular << " " << share << " " << accuracy << " " << column;
          }
      }
    }
    EXPECT_GT(compared, 1) << each.exponent << " " << each.annular;
  }
}

/// Too long a step: the vectors stay as they were.
TEST(RegularTangents, RefuseWhatDoesNotConverge) {
  PowerContact<4> at({});
  RegularExpansion<4> motion(at.system, rounding_of_series);
  ASSERT_TRUE(at.expand(motion, PowerContact<4>::state(0.02, 0.7)));
  Eigen::MatrixXd vectors = Eigen::MatrixXd::Identity(8, 8);
  EXPECT_FALSE(RegularTangents<4>(at.system).pass(motion, 5 * motion.converged(), 1e-13, {},
                                                  Eigen::Map<Eigen::MatrixXd>(vectors.data(), 8, 8)));
  EXPECT_TRUE(vectors.isIdentity(0));
}

}  // namespace
}  // namespace rubsweep::integrate::taylor
