// Slow turns on a moving belt at a stiff wall, with friction that depends on the slip. Implicit steps are
// used after the wall's vibration has died out; they are compared with Taylor pieces and with an explicit
// stepper.
#include "rubsweep/core/integrate/stiff_turns.hpp"

#include <gtest/gtest.h>

#include "core/integrate/largest_difference.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "rubsweep/core/integrate/taylor/taylor_run.hpp"
#include "support/simple_scenes.hpp"

namespace rubsweep::integrate {
namespace {

using std::numbers::pi;

/// Unit mass on unit springs, pressed by 2 N onto a wall across x with a moving surface; the wall's vibration
/// has a phase of 1e4 radians per radian of the shaft.
struct Belt {
  double damping = 2e3, unbalance_n = 0.3, steepness = 1;

  scene::Scene scene() const {
    auto scene = test::one_mass_scene(1, 1, 0.05, 2 * pi, 1);
    scene.constant_n << 3, 0;
    scene.harmonic_n << unbalance_n, std::complex<double>(0, -unbalance_n);
    scene::Contact wall = test::wall_across_x(1, 1, 1e8, damping);
    wall.friction = model::StribeckFriction{{0, 0, 0, 0.3, steepness, 0}};
    wall.surface_speed_m_per_s = 0.5;
    scene.contacts.push_back(wall);
    scene.displacement_m << 1 + 2.1e-8, 0.1;
    return scene;
  }
};

TEST(StiffTurns, OnABeltTheyAreMadeOfFewStepsAndMoveAsByPieces) {
  const scene::Scene scene = Belt{}.scene();
  exact::modes::ModeCache modes;
  const run::Run run = start(scene, {}, modes);
  taylor::TaylorRun<2> pieces(scene, {});
  const run::TurnRequest asked{.samples_per_revolution = 16, .peaks = true};
  run::TurnReport a, b;
  long steps = 0;
  for (int k = 0; k < 6; ++k) {
    const long before = a.effort.steps;
    ASSERT_EQ(run.advance(asked, a), run::Outcome::ok);
    ASSERT_EQ(pieces.advance(asked, b), run::Outcome::ok);
    steps = a.effort.steps - before;
    EXPECT_LT(largest_difference(a.section, b.section), 1e-8) << k;
    EXPECT_LT(largest_difference(a.samples, b.samples), 1e-8) << k;
    EXPECT_NEAR(a.peak_contact_force_n, b.peak_contact_force_n, 1e-6) << k;
    EXPECT_NEAR(a.peak_displacement_m, b.peak_displacement_m, 1e-8) << k;
    EXPECT_NEAR(a.contact_fraction, 1, 1e-12) << k;
  }
  EXPECT_GE(a.effort.adaptive_turns, 4);
  EXPECT_LT(steps, 1000);
  EXPECT_GT(b.effort.steps, 6 * 5000);
}

TEST(StiffTurns, OnABeltTheyMoveAsByAnExplicitStepper) {
  const scene::Scene scene = Belt{.unbalance_n = 0.8, .steepness = 2}.scene();
  exact::modes::ModeCache modes;
  run::SolverOptions explicitly;
  explicitly.method = run::Method::adaptive;
  explicitly.stepper = run::Stepper::dopri5;
  explicitly.relative_tolerance = 1e-10;
  const run::Run run = start(scene, {}, modes), stepper = start(scene, explicitly, modes);
  run::TurnReport a, b;
  for (int k = 0; k < 3; ++k) {
    ASSERT_EQ(run.advance({}, a), run::Outcome::ok);
    ASSERT_EQ(stepper.advance({}, b), run::Outcome::ok);
    EXPECT_LT(largest_difference(a.section, b.section), 1e-7) << k;
  }
  EXPECT_GE(a.effort.adaptive_turns, 1);
}

TEST(StiffTurns, AVibrationThatLastsIsLeftToPieces) {
  const scene::Scene scene = Belt{.damping = 0}.scene();
  exact::modes::ModeCache modes;
  const run::Run run = start(scene, {}, modes);
  taylor::TaylorRun<2> pieces(scene, {});
  run::TurnReport a, b;
  for (int k = 0; k < 4; ++k) {
    ASSERT_EQ(run.advance({}, a), run::Outcome::ok);
    ASSERT_EQ(pieces.advance({}, b), run::Outcome::ok);
    EXPECT_LT(largest_difference(a.section, b.section), 1e-8) << k;
  }
  EXPECT_EQ(a.effort.adaptive_turns, 0);
}

TEST(StiffTurns, AContactThatOpensInEveryTurnIsLeftToPieces) {
  const scene::Scene scene = Belt{.unbalance_n = 2.5}.scene();
  exact::modes::ModeCache modes;
  const run::Run run = start(scene, {}, modes);
  run::TurnReport turn;
  for (int k = 0; k < 4; ++k) ASSERT_EQ(run.advance({}, turn), run::Outcome::ok);
  EXPECT_GT(turn.effort.switches, 4);
  EXPECT_EQ(turn.effort.adaptive_turns, 0);
}

TEST(StiffTurns, ARestartedRunHasNoMemoryOfThem) {
  const scene::Scene scene = Belt{}.scene();
  exact::modes::ModeCache modes;
  const run::Run run = start(scene, {}, modes);
  run::TurnReport first, again;
  ASSERT_EQ(run.advance({}, first), run::Outcome::ok);
  const std::vector<double> section = first.section;
  for (int k = 0; k < 2; ++k) ASSERT_EQ(run.advance({}, again), run::Outcome::ok);
  run.restart(section);
  ASSERT_EQ(run.advance({}, first), run::Outcome::ok);
  exact::modes::ModeCache other_modes;
  const run::Run other = start(scene, {}, other_modes);
  other.restart(section);
  ASSERT_EQ(other.advance({}, again), run::Outcome::ok);
  EXPECT_EQ(first.section, again.section);
}

}  // namespace
}  // namespace rubsweep::integrate
