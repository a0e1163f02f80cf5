#include <gtest/gtest.h>

#include <cmath>

#include "rubsweep/core/integrate/adaptive/start_adaptive.hpp"
#include "rubsweep/core/integrate/hybrid_run.hpp"
#include "support/simple_scenes.hpp"

namespace rubsweep::integrate {
namespace {

/// Free vibration inside an annular stop has a closed form; at contact the adaptive solver must take over.
scene::Scene annular_scene(double start_x, double start_vy) {
  auto scene = test::one_mass_scene(1, 400, 1, 0.25, 1);
  scene.displacement_m << start_x, 0;
  scene.velocity_m_per_s << 0, start_vy;
  scene::Contact stop;
  stop.wall = contact::AnnularWall{{0.1, 0}};
  stop.clearance_m = 1;
  stop.stiffness_n_per_m = 1e4;
  stop.damping_ns_per_m = 5;
  stop.friction = model::ConstantFriction{0.1};
  scene.contacts.push_back(stop);
  return scene;
}

TEST(ExactAnnular, FlightInTheClosedForm) {
  const auto scene = annular_scene(0.89, 3);
  exact::modes::ModeCache modes;
  const auto run = start_hybrid(scene, {}, modes);
  run::TurnReport turn;
  for (int k = 0; k < 4; ++k) ASSERT_EQ(run.advance({}, turn), run::Outcome::ok);
  EXPECT_EQ(turn.effort.taylor_turns + turn.effort.adaptive_turns, 0);
  const double t = 1, w = std::sqrt(400 - 0.25), decay = std::exp(-t / 2);
  EXPECT_NEAR(turn.section[0], 0.89 * decay * (std::cos(w * t) + std::sin(w * t) / (2 * w)), 1e-13);
  EXPECT_NEAR(turn.section[1], 3 / w * decay * std::sin(w * t), 1e-13);
}

TEST(ExactAnnular, EveryTouchIsSeenAndIntegrated) {
  for (const double speed : {0.0, 3.0, 8.0, 17.9, 18.1, 25.0}) {
    SCOPED_TRACE(speed);
    const auto scene = annular_scene(-0.85, speed);
    run::SolverOptions options;
    options.relative_tolerance = 1e-11;
    exact::modes::ModeCache modes;
    const auto run = start_hybrid(scene, options, modes);
    const run::Cursor adaptive = adaptive::start_adaptive(scene, options);
    run::TurnReport a, b;
    for (int k = 0; k < 8; ++k) {
      ASSERT_EQ(run.advance({}, a), run::Outcome::ok);
      ASSERT_EQ(adaptive({}, b), run::Outcome::ok);
      EXPECT_EQ(a.hits, b.hits) << k;
      for (std::size_t i = 0; i < a.section.size(); ++i) EXPECT_NEAR(a.section[i], b.section[i], 1e-7) << k;
    }
  }
}

}  // namespace
}  // namespace rubsweep::integrate
