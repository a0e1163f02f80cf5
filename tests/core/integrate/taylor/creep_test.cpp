#include "rubsweep/core/integrate/taylor/creep.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <limits>
#include <string>
#include <vector>

#include "core/integrate/largest_difference.hpp"
#include "rubsweep/core/integrate/adaptive/start_adaptive.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "rubsweep/core/integrate/taylor/taylor_run.hpp"
#include "support/annular_scene.hpp"
#include "support/rolling_scene.hpp"
#include "support/simple_scenes.hpp"

namespace rubsweep::integrate::taylor {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// Rolling follows its closed form for friction of any steepness, without the help of a stepper.
TEST(Creep, RollsOnItsClosedForm) {
  for (const double steepness : {1e3, 1e4, 1e5, 1e7}) {
    const test::RollingScene rolling = test::rolling_scene(steepness);
    exact::modes::ModeCache modes;
    const run::Run run = start(rolling.scene, {}, modes);
    run::TurnReport turn;
    for (int k = 1; k <= 6; ++k) {
      ASSERT_EQ(run.advance({}, turn), run::Outcome::ok) << steepness;
      const auto z = rolling.displacement(k), v = rolling.velocity(k);
      EXPECT_LT(largest_difference(turn.section, {z.real(), z.imag(), v.real(), v.imag()}), 1e-12)
          << steepness;
    }
    EXPECT_EQ(turn.effort.adaptive_turns, 0);
    EXPECT_EQ(turn.effort.taylor_turns, 6);
    EXPECT_GT(turn.effort.creep_pieces, 12) << steepness;
    EXPECT_LT(turn.effort.taylor_pieces, 6 * 100) << steepness;
  }
}

/// A whip in a ring that changes to rolling, shaken by an unbalance.
scene::Scene whip_that_rolls(double steepness) {
  scene::Scene scene = test::rolling_scene(steepness).scene;
  scene.contacts[0].friction = model::StribeckFriction{{0.01, steepness, steepness / 30, 0.2, steepness, 0}};
  scene.contacts[0].damping_ns_per_m = 0.02;
  scene.harmonic_n << 0.01, std::complex<double>(0, -0.01);
  scene.velocity_m_per_s *= 0.9;
  return scene;
}

/// A driven mass pressed onto a moving belt, which carries it along and releases it repeatedly.
scene::Scene belt(double steepness) {
  scene::Scene scene = test::one_mass_scene(1, 1, 0.1, 4, 1);
  scene.structure.stiffness(0, 0) = 0;
  scene.constant_n << 2, 0;
  scene.harmonic_n << 0.2, 0.6;
  scene::Contact wall = test::wall_across_x(1, 1, 100, 1);
  wall.friction = model::StribeckFriction{{0, 0, 0, 0.25, steepness, 0.001}};
  wall.surface_speed_m_per_s = 0.5;
  scene.contacts.push_back(wall);
  scene.displacement_m << 1.02, 0.3;
  return scene;
}

struct Named {
  std::string name;
  scene::Scene scene;
};

std::vector<Named> machines(double steepness) {
  return {{"rolling", test::rolling_scene(steepness).scene},
          {"whip", whip_that_rolls(steepness)},
          {"belt", belt(steepness)}};
}

/// Compares each turn with short pieces that resolve the fast friction, from the same sections: states,
/// samples, peaks, mode changes and tangent vectors.
TEST(Creep, IsTheMotionOfShortPieces) {
  for (const double steepness : {1e3, 1e4}) {
    for (const auto& [name, scene] : machines(steepness)) {
      TaylorRun<2> creeping(scene, {}), alone(scene, {}, {.creep_above = never});
      const run::TurnRequest plain{.samples_per_revolution = 16, .peaks = true},
          with_tangents{.tangent_vectors = Eigen::MatrixXd::Identity(4, 4)};
      run::TurnReport a, b;
      for (int k = 0; k < 8; ++k) {
        const run::TurnRequest& asked = k % 2 == 0 ? plain : with_tangents;
        const std::vector<double> before = creeping.section();
        alone.resume(before, k);
        ASSERT_EQ(creeping.advance(asked, a), run::Outcome::ok) << name;
        ASSERT_EQ(alone.advance(asked, b), run::Outcome::ok) << name;
        EXPECT_LT(largest_difference(a.section, b.section), 1e-12) << name << ' ' << steepness << ' ' << k;
        EXPECT_EQ(a.hits, b.hits);
        EXPECT_NEAR(a.contact_fraction, b.contact_fraction, 1e-12);
        if (k % 2 == 0) {
          EXPECT_LT(largest_difference(a.samples, b.samples), 1e-12) << name;
          EXPECT_NEAR(a.peak_displacement_m, b.peak_displacement_m, 1e-6 * b.peak_displacement_m);
          EXPECT_NEAR(a.peak_contact_force_n, b.peak_contact_force_n, 1e-6 * b.peak_contact_force_n);
        } else {
          ASSERT_TRUE(a.tangent_vectors.get() && b.tangent_vectors.get());
          const Eigen::MatrixXd &of_a = *a.tangent_vectors.get(), &of_b = *b.tangent_vectors.get();
          EXPECT_LT((of_a - of_b).cwiseAbs().maxCoeff(), 1e-9 * of_b.cwiseAbs().maxCoeff())
              << name << ' ' << steepness << ' ' << k;
        }
      }
      EXPECT_GT(creeping.effort().creep_pieces, 0) << name;
      const int gain = steepness < 2e3 ? 1 : 3;
      EXPECT_LT(gain * creeping.effort().steps, alone.effort().steps) << name << ' ' << steepness;
      EXPECT_EQ(alone.effort().creep_pieces, 0);
    }
  }
}

/// Compares with another method, rkf78, whose steps are just as short because of friction.
TEST(Creep, IsTheMotionOfASmallTolerance) {
  for (const auto& [name, scene] : machines(3e3)) {
    run::SolverOptions tight{.method = run::Method::adaptive, .stepper = run::Stepper::rkf78};
    tight.relative_tolerance = 1e-13;
    const run::Cursor other = adaptive::start_adaptive(scene, tight);
    TaylorRun<2> creeping(scene, {});
    run::TurnReport a, b;
    for (int k = 0; k < 6; ++k) {
      ASSERT_EQ(creeping.advance({}, a), run::Outcome::ok) << name;
      ASSERT_EQ(other({}, b), run::Outcome::ok) << name;
      EXPECT_LT(largest_difference(a.section, b.section), 1e-10) << name << ' ' << k;
    }
    EXPECT_GT(creeping.effort().creep_pieces, 0) << name;
  }
}

/// At the largest steepness the motion approaches that with dry friction.
TEST(Creep, ApproachesDryFriction) {
  scene::Scene dry = belt(1);
  dry.contacts[0].friction = model::ConstantFriction{0.25};
  TaylorRun<2> limit(dry, {});
  run::TurnReport b;
  for (int k = 0; k < 3; ++k) ASSERT_EQ(limit.advance({}, b), run::Outcome::ok);
  double last = 1;
  for (const double steepness : {1e3, 1e4, 1e5}) {
    scene::Scene steep = belt(1);
    steep.contacts[0].friction = model::StribeckFriction{{0, 0, 0, 0.25, steepness, 0}};
    TaylorRun<2> run(steep, {});
    run::TurnReport a;
    for (int k = 0; k < 3; ++k) ASSERT_EQ(run.advance({}, a), run::Outcome::ok);
    const double difference = largest_difference(a.section, b.section);
    EXPECT_LT(difference, 0.2 * last) << steepness;
    last = difference;
  }
  EXPECT_LT(last, 1e-4);
}

}  // namespace
}  // namespace rubsweep::integrate::taylor
