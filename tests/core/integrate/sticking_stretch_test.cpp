// Bodies that dry friction holds at stiff flat walls: closed forms and certified steps against what friction
// and springs say by hand, against Taylor pieces all the way, and against a stepper.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/integrate/largest_difference.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "rubsweep/core/integrate/taylor/taylor_run.hpp"
#include "support/simple_scenes.hpp"

namespace rubsweep::integrate {
namespace {

using std::numbers::pi;

/// Unit mass on unit springs along x and y, a stiff damped wall across x that it is pressed on, whose surface
/// may move; one revolution lasts 2 pi seconds over `speed`.
struct Held {
  double stiffness = 1e8, damping = 2e3, pressed_n = 2, mu = 0.5, surface = 0, speed = 1;
  double unbalance_n = 0, structure_damping = 0.05;

  scene::Scene scene(double y, double rate) const {
    auto scene = test::one_mass_scene(1, 1, structure_damping, 2 * pi / speed, 1);
    scene.constant_n << pressed_n + 1, 0;
    scene.harmonic_n << unbalance_n, std::complex<double>(0, -unbalance_n);
    scene::Contact wall = test::wall_across_x(1, 1, stiffness, damping);
    wall.friction = model::ConstantFriction{mu};
    wall.surface_speed_m_per_s = surface;
    scene.contacts.push_back(wall);
    scene.displacement_m << 1 + pressed_n / stiffness, y;
    scene.velocity_m_per_s << 0, rate;
    return scene;
  }
};

TEST(StickingStretch, ABodyHeldByFrictionCostsWhatOneAtRestDoes) {
  const Held held{.speed = 0.1};
  exact::modes::ModeCache modes;
  const run::Run run = start(held.scene(0.7, 0), {}, modes);
  run::TurnRequest asked{.samples_per_revolution = 16, .peaks = true};
  run::TurnReport turn;
  for (int k = 0; k < 20; ++k) {
    ASSERT_EQ(run.advance(asked, turn), run::Outcome::ok);
    EXPECT_NEAR(turn.section[1], 0.7, 1e-14);
    EXPECT_NEAR(turn.section[3], 0, 1e-15);
    EXPECT_NEAR(turn.contact_fraction, 1, 1e-12);
    EXPECT_NEAR(turn.peak_contact_force_n, held.pressed_n, 1e-7);
    ASSERT_EQ(turn.sample_count, 16);
    for (std::size_t s = 0; s < 16; ++s) EXPECT_NEAR(turn.samples[4 * s + 1], 0.7, 1e-14);
  }
  // The wall's vibration turns by 6e5 radians in each of these revolutions.
  EXPECT_LT(turn.effort.steps, 20 * 10);
}

/// The same turns by the run that `start` makes and by Taylor pieces alone.
void expect_like_pieces(const scene::Scene& scene, int turns, double tolerance, long most_steps) {
  exact::modes::ModeCache modes;
  const run::Run run = start(scene, {}, modes);
  taylor::TaylorRun<2> pieces(scene, {});
  run::TurnRequest asked{.samples_per_revolution = 32, .peaks = true};
  run::TurnReport a, b;
  for (int k = 0; k < turns; ++k) {
    asked.tangent_vectors = Eigen::MatrixXd::Identity(4, 4);
    ASSERT_EQ(run.advance(asked, a), run::Outcome::ok);
    ASSERT_EQ(pieces.advance(asked, b), run::Outcome::ok);
    EXPECT_LT(largest_difference(a.section, b.section), tolerance) << k;
    EXPECT_LT(largest_difference(a.samples, b.samples), tolerance) << k;
    EXPECT_NEAR(a.peak_contact_force_n, b.peak_contact_force_n, 1e-6) << k;
    EXPECT_NEAR(a.peak_displacement_m, b.peak_displacement_m, 1e-8) << k;
    EXPECT_NEAR(a.contact_fraction, b.contact_fraction, 1e-12) << k;
    EXPECT_EQ(a.hits, b.hits);
    ASSERT_NE(a.tangent_vectors.get(), nullptr);
    // Pieces add 4e-12 of the vectors each.
    const Eigen::MatrixXd &by_run = *a.tangent_vectors.get(), &by_pieces = *b.tangent_vectors.get();
    EXPECT_LT((by_run - by_pieces).norm(), 1e-7 * (1 + by_pieces.norm())) << k;
  }
  EXPECT_LT(a.effort.steps, most_steps);
  EXPECT_LT(a.effort.steps, b.effort.steps / 4);
}

TEST(StickingStretch, AHeldBodyThatUnbalancePressesMovesAsByTaylorPieces) {
  Held held{.stiffness = 1e6, .damping = 400, .unbalance_n = 0.3};
  expect_like_pieces(held.scene(0.4, 0), 5, 1e-11, 400);
}

TEST(StickingStretch, ABeltCarriesTheBodyAsByTaylorPieces) {
  // Let go where the spring asks for more than mu N = 1: y = -1 after twenty seconds, in the fourth turn.
  Held held{.stiffness = 1e6, .damping = 400, .surface = 0.05};
  expect_like_pieces(held.scene(0, -0.05), 3, 1e-11, 300);
}

TEST(StickingStretch, ABeltLetsTheBodyGoWhereTheSpringIsAsStrongAsFriction) {
  // Against a damper c V the belt lets go at y = -(mu N - c V), as by a stepper.
  const Held held{.stiffness = 1e6, .damping = 400, .surface = 0.05};
  exact::modes::ModeCache modes;
  run::SolverOptions tight;
  tight.method = run::Method::adaptive;
  tight.stepper = run::Stepper::dopri5;
  tight.relative_tolerance = 1e-10;
  const run::Run run = start(held.scene(0, -0.05), {}, modes),
                 stepper = start(held.scene(0, -0.05), tight, modes);
  run::TurnReport a, b;
  for (int k = 0; k < 4; ++k) {
    ASSERT_EQ(run.advance({}, a), run::Outcome::ok);
    ASSERT_EQ(stepper.advance({}, b), run::Outcome::ok);
    EXPECT_NEAR(a.section[1], b.section[1], 1e-7) << k;
    EXPECT_NEAR(a.section[3], b.section[3], 1e-7) << k;
    if (k < 3) {
      EXPECT_NEAR(a.section[1], -0.05 * 2 * pi * (k + 1), 1e-13) << k;
    }
  }
  EXPECT_GT(a.section[3], -0.05 + 1e-3);
}

TEST(StickingStretch, UndampedVibrationAgainstTheWallNeitherEndsNorIsLost) {
  // Pressed by 2 N and struck: the load swings by a tenth, friction holds all the same. The wall's spring is
  // beside the structure's: a cosine of rate sqrt(k + K) about the position where both carry the forces.
  const Held held{.stiffness = 1e6, .damping = 0, .structure_damping = 0};
  scene::Scene scene = held.scene(0.4, 0);
  scene.displacement_m(0) += 2e-7;
  const double rate = std::sqrt(1 + held.stiffness),
               rest = (held.pressed_n + 1 + held.stiffness) / (1 + held.stiffness),
               amplitude = scene.displacement_m(0) - rest;
  exact::modes::ModeCache modes;
  const run::Run run = start(scene, {}, modes);
  run::TurnReport turn;
  for (int k = 1; k <= 4; ++k) {
    ASSERT_EQ(run.advance({}, turn), run::Outcome::ok);
    const double angle = rate * 2 * pi * k;
    EXPECT_NEAR(turn.section[0], rest + amplitude * std::cos(angle), 1e-15 * k) << k;
    EXPECT_NEAR(turn.section[2], -amplitude * rate * std::sin(angle), 1e-12 * k) << k;
    EXPECT_NEAR(turn.section[1], 0.4, 1e-14) << k;
  }
  EXPECT_LT(turn.effort.steps, 200);
  // A phase of 6000 radians a turn: pieces add up what each of them rounds.
  expect_like_pieces(scene, 2, 1e-9, 200);
}

}  // namespace
}  // namespace rubsweep::integrate
