#include "rubsweep/core/integrate/exact/tube/tube_switch.hpp"

#include <gtest/gtest.h>

#include "core/integrate/exact/rubbing_turn.hpp"

namespace rubsweep::integrate::exact::tube {
namespace {

/// A reference motion that flies and then touches its wall.
struct Landing {
  RubbingTurn turn;
  TubeReference<4> reference{turn.scene, turn.modes.modes_of<4>(turn.scene)};
  ExactMotion<4>::GuardValue before;
  double landing_s = 0;

  Landing() {
    std::vector<double> near(8, 0.0);
    near[1] = 0.999;  // a thousandth of the clearance before the wall, approaching
    near[5] = 3;
    EXPECT_TRUE(reference.start(near, Eigen::MatrixXd::Identity(8, 8)));
    EXPECT_EQ(reference.motion().joint(), 0u);
    before = reference.motion().guard(0);
    landing_s = reference.motion().land(0, reference.motion().reach_s());
  }
};

TEST(TubeSwitch, TheLawsDifferByAVectorTimesTheGuard) {
  Landing landing;
  ExactMotion<4>& motion = landing.reference.motion();
  const Eigen::MatrixXd open = motion.mode().generator;
  const Eigen::RowVectorXd row = motion.mode().guards[0].physical;
  TubeSwitch<4> change(landing.reference);
  const auto made = change.through(0, landing.before, {.width = {1e-3}}, landing.landing_s);
  ASSERT_TRUE(made);
  EXPECT_EQ(motion.mode().modes[0], contact::Mode::clamped);
  const Eigen::MatrixXd difference = motion.mode().generator - open;
  const Eigen::VectorXd b = difference * row.transpose() / row.squaredNorm();
  EXPECT_LE((difference - b * row).norm(), 1e-9 * difference.norm());
  EXPECT_NEAR(made->own_deflection, std::abs(row.dot(b.transpose())), 1e-9 * made->own_deflection);
  // From this switch on the run carries b and the image of b under the new law.
  EXPECT_EQ(motion.tangents().size(), 10u);
}

TEST(TubeSwitch, SaysHowFastTheGuardRises) {
  Landing landing;
  const double rate = landing.reference.motion().guard(0).rate;
  TubeSwitch<4> change(landing.reference);
  const auto made = change.through(0, landing.before, {.width = {1e-3}}, landing.landing_s);
  ASSERT_TRUE(made);
  EXPECT_EQ(made->rate, rate);
  EXPECT_GT(made->lowest_rate, 0);
  EXPECT_LE(made->lowest_rate, std::min(rate, landing.before.rate) * (1 + 1e-12));
  EXPECT_EQ(made->spread.width.fast, 1e-3);
  EXPECT_GT(made->longest_window_s, 0);
  for (const TurnTube::Other& other : made->others) EXPECT_LT(other.value, 0);
}

/// The guard of open is p, that of clamped is K p - d v: neither is the negative of the other.
TEST(TubeSwitch, NoGuardStandsBehindATouch) {
  Landing landing;
  TubeSwitch<4> change(landing.reference);
  ASSERT_TRUE(change.through(0, landing.before, {}, landing.landing_s));
  EXPECT_EQ(change.behind(), TubeSwitch<4>::none);
}

}  // namespace
}  // namespace rubsweep::integrate::exact::tube
