#include "rubsweep/core/integrate/run/state_scale.hpp"

#include <gtest/gtest.h>

#include "support/set_a_cell.hpp"

namespace rubsweep::integrate::run {
namespace {

constexpr StateScale scale{.length_m = 1e-3, .speed_rad_per_s = 400};

TEST(StateScale, IsThatOfLengthsAndRadians) {
  EXPECT_DOUBLE_EQ(scale.unit_velocity_m_per_s(), 0.4);
  EXPECT_DOUBLE_EQ(scale.unit_acceleration_m_per_s2(), 160);
  EXPECT_DOUBLE_EQ(scale.stiffness_n(2e6), 2e3);
  EXPECT_DOUBLE_EQ(scale.damping_n(50), 20);
  EXPECT_DOUBLE_EQ(scale.duration(0.005), 2);
}

TEST(StateScale, TakesStatesFromSiAndBack) {
  const std::vector<double> state = scale.state(Eigen::Vector2d(2e-3, -1e-3), Eigen::Vector2d(0.2, 0.8));
  ASSERT_EQ(state.size(), 4u);
  EXPECT_DOUBLE_EQ(state[0], 2);
  EXPECT_DOUBLE_EQ(state[1], -1);
  EXPECT_DOUBLE_EQ(state[2], 0.5);
  EXPECT_DOUBLE_EQ(state[3], 2);
  EXPECT_TRUE(scale.displacement_m(state).isApprox(Eigen::Vector2d(2e-3, -1e-3), 1e-15));
  EXPECT_TRUE(scale.velocity_m_per_s(state).isApprox(Eigen::Vector2d(0.2, 0.8), 1e-15));
}

TEST(StateScale, InSecondsOnlyVelocitiesDiffer) {
  const StateScale seconds = scale.in_seconds();
  EXPECT_EQ(seconds.unit_velocity_m_per_s(), scale.length_m);
  EXPECT_EQ(seconds.unit_acceleration_m_per_s2(), scale.length_m);
  EXPECT_EQ(seconds.duration(0.005), 0.005);
  Eigen::Vector4d state(2, -1, 0.5, 2);
  scale.to_seconds(state);
  EXPECT_EQ(state, Eigen::Vector4d(2, -1, 200, 800));
  EXPECT_TRUE(seconds.velocity_m_per_s(std::vector<double>{2, -1, 200, 800})
                  .isApprox(Eigen::Vector2d(0.2, 0.8), 1e-15));
  scale.from_seconds(state);
  EXPECT_EQ(state, Eigen::Vector4d(2, -1, 0.5, 2));
}

TEST(StateScale, ASceneStartsAtTheSectionThatItIsGiven) {
  scene::Scene scene = test::cell_of({}).scene;
  const std::vector<double> start = scaled_initial_state(scene);
  ASSERT_EQ(start.size(), 8u);
  EXPECT_DOUBLE_EQ(start[1], scene.displacement_m(1) / scene.length_scale_m);
  EXPECT_DOUBLE_EQ(start[4], scene.velocity_m_per_s(0) / (scene.length_scale_m * scene.speed_rad_per_s));
  const std::vector<double> other{0.5, -0.25, 0, 0.125, 1, 2, -4, 0};
  set_initial_state(scene, other);
  const std::vector<double> back = scaled_initial_state(scene);
  for (std::size_t i = 0; i < other.size(); ++i) EXPECT_DOUBLE_EQ(back[i], other[i]);
}

}  // namespace
}  // namespace rubsweep::integrate::run
