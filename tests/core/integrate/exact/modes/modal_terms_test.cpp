#include "rubsweep/core/integrate/exact/modes/modal_terms.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rubsweep/core/integrate/exact/exact_motion.hpp"
#include "rubsweep/core/numerics/matrix_flow.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::integrate::exact::modes {
namespace {

TEST(ModalTermsPairSize, BoundsTheLengthByAtMostAnEighthMore) {
  for (double angle = 0; angle < 6.3; angle += 0.01) {
    const double size = pair_size(3 * std::cos(angle), 3 * std::sin(angle));
    EXPECT_GE(size, 3 * (1 - 1e-15)) << angle;
    EXPECT_LE(size, 3 * 1.125) << angle;
  }
}

TEST(ModalTerms, SlowOnesFirstAndNoneThatIsNotSeen) {
  Eigen::Matrix<double, 4, Eigen::Dynamic> rows = Eigen::MatrixXd::Zero(4, 8);
  rows.col(0) << 1, 2, 3, 4;
  rows.col(7) << 5, 6, 7, 8;  // rate of the fourth pair
  rows.col(2) << 9, 10, 11, 12;
  const ModalTerms terms = modal_terms(rows, {true, false, false, true});
  ASSERT_EQ(terms.list.size(), 3u);
  EXPECT_EQ(terms.slow().size(), 1u);
  EXPECT_EQ(terms.list[0].u, 2);
  EXPECT_EQ(terms.list[1].u, 0);
  EXPECT_EQ(terms.list[2].u, 3);
  EXPECT_EQ(terms.list[2].v, 7);
  EXPECT_EQ(terms.list[2].value[1], 5);
  EXPECT_EQ(terms.list[2].rate[1], 6);
  EXPECT_EQ(terms.list[2].bound[1], 7);
  EXPECT_EQ(terms.list[0].envelope, 12);
  EXPECT_EQ(terms.fast().size(), 2u);
}

TEST(ModalTerms, WhereNothingIsSeenOnePairAddsNothing) {
  const ModalTerms terms = modal_terms(Eigen::MatrixXd::Zero(4, 8), {true, true, true, true});
  ASSERT_EQ(terms.fast().size(), 1u);
  const Eigen::VectorXd z = Eigen::VectorXd::Ones(8);
  const ModalSum sum(terms.fast().front(), z.data(), true);
  EXPECT_EQ(sum.value(), 0);
  EXPECT_EQ(sum.rate(), 0);
  EXPECT_EQ(sum.curvature(), 0);
}

using State = ExactTypes<4>::State;

/// Tests that run in each of the four modes of one stop.
class ModalTermsEveryModeSeen : public testing::TestWithParam<std::size_t> {
 protected:
  MachineModes<4> plan_{test::cell_of({}).scene};
  const LinearMode<4>& mode_ = *plan_.mode(GetParam());

  State some_vibration() const {
    State z;
    z << 0.3, -0.2, 0.01, 0.04, -0.5, 0.1, 0.02, -0.03;
    return z;
  }

  State moved(double duration_s) const {
    return mode_.inverse *
           (numerics::matrix_flow(mode_.generator, duration_s) * (mode_.basis * some_vibration()));
  }

  ModalSum sum(std::span<const ModalTerm> pairs, const State& z) const {
    return sum_of(pairs, z.data(), mode_.paired);
  }
};

TEST_P(ModalTermsEveryModeSeen, SumsToTheWholeRow) {
  for (const auto& guard : mode_.guards) {
    const Eigen::RowVectorXd row = guard.physical * mode_.basis;
    const Eigen::RowVectorXd by_time = guard.physical * mode_.generator * mode_.basis;
    const ModalSum seen = sum(guard.terms.list, some_vibration());
    EXPECT_NEAR(seen.value(), row * some_vibration(), 1e-14);
    EXPECT_NEAR(seen.rate(), by_time * some_vibration(), 1e-12 * by_time.cwiseAbs().sum());
  }
}

TEST_P(ModalTermsEveryModeSeen, BoundsHoldOverTheLongestStep) {
  for (const auto& guard : mode_.guards) {
    const ModalSum start = sum(guard.terms.list, some_vibration());
    double envelope = 0;
    for (const ModalTerm& pair : guard.terms.fast())
      envelope += pair.envelope * pair_size(some_vibration()(pair.u), some_vibration()(pair.v));
    const Eigen::RowVectorXd twice = guard.physical * mode_.generator * mode_.generator * mode_.basis;
    for (int i = 0; i <= 200; ++i) {
      const State later = moved(mode_.longest_step_s * i / 200);
      EXPECT_LE(std::abs(twice * later), start.curvature()) << i;
      if (mode_.paired) {
        EXPECT_LE(std::abs(sum(guard.terms.fast(), later).value()), envelope * (1 + 1e-12)) << i;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(OneStop, ModalTermsEveryModeSeen, testing::Range<std::size_t>(0, 4));

/// During flight with a ringing casing, the slow bound of the penetration is never below the penetration.
TEST(ModalTermsSlowGuard, IsNeverBelowTheWhole) {
  auto scene = test::cell_of({}).scene;
  scene.pulses.clear();
  ExactMotion<4> motion(scene, std::make_shared<MachineModes<4>>(scene));
  State start = State::Zero();
  start(3) = 0.4;
  start(5) = 100;
  motion.set_phases(0);
  ASSERT_TRUE(motion.enter(0, start));
  const LinearGuard<4>& plan = motion.mode().guards.front();
  ASSERT_EQ(plan.terms.slow_count, 1u);
  for (int i = 0; i < 100; ++i) {
    const auto forced = motion.forced_guard(0);
    const ModalSum seen = motion.slow_sum(plan);
    const auto slow = motion.slow_guard(plan, seen, forced);
    const auto whole = motion.whole_guard(plan, motion.with_fast(plan, seen), forced);
    EXPECT_GE(slow.value, whole.value) << i;
    EXPECT_NEAR(whole.value, plan.physical * motion.physical() - 1, 1e-13) << i;
    motion.step_by_table(10);
  }
}

}  // namespace
}  // namespace rubsweep::integrate::exact::modes
