#include "rubsweep/core/integrate/taylor/creep_choice.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "support/rolling_scene.hpp"

namespace rubsweep::integrate::taylor {
namespace {

constexpr double above = 20;

/// A rotor that rolls inside a ring, expanded at its initial state.
struct Rolling {
  explicit Rolling(double steepness_s_per_m)
      : scene(test::rolling_scene(steepness_s_per_m).scene),
        system(run::scale<2>(scene)),
        dynamics(system, 0),
        motion(system),
        pulses(scene, system.scale, 2 * std::numbers::pi),
        state(run::scaled_initial_state(scene)),
        settled(state) {
    dynamics.follow(pulses);
    dynamics.modes().assign(1, contact::Mode::sprung);
    expand(state);
  }
  void expand(const std::vector<double>& from) {
    motion.expand(from.data(), 0, pulses, dynamics.modes(), dynamics.slips());
  }
  bool begin(CreepChoice<2>& choice, double usual_rad) {
    return choice.begin(
        motion, dynamics, [this](const std::vector<double>& from) { expand(from); }, state, settled, 0.5,
        usual_rad);
  }
  double ratio() const { return friction_ratio(motion, dynamics, state); }

  scene::Scene scene;
  run::ScaledSystem<2> system;
  law::Dynamics<2, false> dynamics;
  Expansion<2> motion;
  run::PulseTimes pulses;
  std::vector<double> state, settled;
};

TEST(CreepChoice, ExpandsAContactThatFrictionHoldsAndNotTheNextOne) {
  Rolling rolling(1e5);
  CreepChoice<2> choice(above);
  ASSERT_GT(rolling.ratio(), above);
  ASSERT_TRUE(choice.due(rolling.ratio()));
  ASSERT_TRUE(rolling.begin(choice, 1e-3));
  EXPECT_TRUE(rolling.motion.any_creeps());
  EXPECT_EQ(rolling.ratio(), 0);  // nothing creeps
  EXPECT_GT(choice.known_rad(), 12e-3);
  EXPECT_LE(choice.known_rad(), 0.5);
  choice.end(rolling.motion, rolling.dynamics);
  rolling.expand(rolling.state);
  EXPECT_FALSE(rolling.motion.any_creeps());
  EXPECT_GT(rolling.ratio(), above);
}

/// A creeping piece must replace a dozen usual ones; otherwise the expansion stays unchanged.
TEST(CreepChoice, LeavesTheExpansionWhereAPieceIsNotWorthIt) {
  Rolling rolling(1e5);
  const std::vector<double> before = rolling.state;
  const double converged = rolling.motion.series().converged_rad(1);
  CreepChoice<2> choice(above);
  ASSERT_TRUE(choice.due(rolling.ratio()));
  EXPECT_FALSE(rolling.begin(choice, 0.5));
  EXPECT_FALSE(rolling.motion.any_creeps());
  EXPECT_EQ(rolling.state, before);
  EXPECT_EQ(rolling.motion.series().converged_rad(1), converged);
  EXPECT_EQ(choice.known_rad(), 0);
  EXPECT_FALSE(choice.due(rolling.ratio()));
}

TEST(CreepChoice, WaitsForSixPiecesOfSteepFriction) {
  CreepChoice<2> choice(above);
  EXPECT_FALSE(choice.due(above));
  EXPECT_TRUE(choice.due(2 * above));
  choice.wait();
  EXPECT_FALSE(choice.due(0));  // has no effect, because friction is not steep
  for (int piece = 0; piece < 6; ++piece) EXPECT_FALSE(choice.due(2 * above)) << piece;
  EXPECT_TRUE(choice.due(2 * above));
  choice.wait();
  choice.begin_turn();
  EXPECT_TRUE(choice.due(2 * above));
}

}  // namespace
}  // namespace rubsweep::integrate::taylor
