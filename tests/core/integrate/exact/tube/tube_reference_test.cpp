#include "rubsweep/core/integrate/exact/tube/tube_reference.hpp"

#include <gtest/gtest.h>

#include "core/integrate/exact/rubbing_turn.hpp"

namespace rubsweep::integrate::exact::tube {
namespace {

/// A guard depends on each disturbance through the product with its row; its rate uses the row's time
/// derivative.
TEST(TubeReference, AGuardSeesItsRowOnEveryDisturbance) {
  RubbingTurn turn;
  TubeReference<4> reference(turn.scene, turn.modes.modes_of<4>(turn.scene));
  ASSERT_TRUE(reference.start(turn.start, Eigen::MatrixXd::Identity(8, 8)));
  EXPECT_EQ(reference.base().all(), 8u);
  const auto& mode = reference.motion().mode();
  for (std::size_t e = 0; e < mode.guards.size(); ++e) {
    const auto seen = reference.seen(e);
    ASSERT_EQ(seen.value.size(), 8u);
    const Eigen::RowVectorXd row = mode.guards[e].physical, rate = row * mode.generator;
    for (Eigen::Index j = 0; j < 8; ++j) {
      const double unit = j < 4 ? 1 : turn.scene.speed_rad_per_s;  // units of a section, with time in seconds
      EXPECT_NEAR(seen.value[static_cast<std::size_t>(j)], unit * row(j), 1e-12 * unit);
      EXPECT_NEAR(seen.rate[static_cast<std::size_t>(j)], unit * rate(j), 1e-9 * unit * rate.norm());
      EXPECT_GE(seen.curvature[static_cast<std::size_t>(j)], 0);
    }
    // With a single Euclidean norm, the width is the norm of the values.
    const auto spread = reference.spread_of(seen.value);
    EXPECT_NEAR(spread.width.fast, Eigen::Map<const Eigen::VectorXd>(seen.value.data(), 8).norm(), 1e-12);
    EXPECT_TRUE(spread.deflections.empty());
  }
}

TEST(TubeReference, DoesNotStartWhereAnAnnularStopIsArmed) {
  RubbingTurn turn;
  turn.scene.contacts[0].wall = contact::AnnularWall{};
  modes::ModeCache modes;
  TubeReference<4> reference(turn.scene, modes.modes_of<4>(turn.scene));
  EXPECT_FALSE(reference.start(turn.start, Eigen::MatrixXd::Identity(8, 8)));
}

TEST(TubeReference, AClampedContactKeepsItsPenetration) {
  RubbingTurn turn;
  std::vector<double> inside = turn.start;
  inside[0] = inside[2] = 0;
  inside[1] = 1.01, inside[3] = 0;  // a hundredth of the clearance inside the wall, closing fast
  inside[5] = 5, inside[7] = 0;
  TubeReference<4> reference(turn.scene, turn.modes.modes_of<4>(turn.scene));
  ASSERT_TRUE(reference.start(inside, Eigen::MatrixXd::Identity(8, 8)));
  ASSERT_EQ(reference.motion().mode().modes[0], contact::Mode::clamped);
  const auto margins = reference.clamped_margins();
  ASSERT_EQ(margins.size(), 1u);
  EXPECT_NEAR(margins[0].margin, 0.01, 1e-12);
  EXPECT_NEAR(margins[0].spread.width.fast, std::sqrt(2), 1e-12);  // rotor against casing
}

}  // namespace
}  // namespace rubsweep::integrate::exact::tube
