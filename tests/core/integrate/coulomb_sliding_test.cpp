// Coulomb sliding, code_aster test SDND104: m = 1 kg without a spring, pressed onto a wall by N = 10 N, mu =
// 0.1, driven along it by A sin 2 pi t. The mean wear power for unit wear coefficient, N mean|v|, is 0.409062
// W at A = 1.5 N. The tanh law approaches this value.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "rubsweep/core/integrate/adaptive/start_adaptive.hpp"
#include "support/simple_scenes.hpp"

namespace rubsweep::integrate {
namespace {

constexpr double published_w = 0.409062;

double mean_wear_power(double steepness_s_per_m, run::Stepper stepper) {
  const double normal_n = 10, stiffness = 1e6;
  auto scene = test::one_mass_scene(1, 0, 0, 1, 1e-2);
  scene.harmonic_n << 0, std::complex<double>(0, -1.5);
  scene.constant_n << normal_n, 0;
  scene::Contact wall = test::wall_across_x(1, 1e-3, stiffness, 100);
  wall.friction = model::StribeckFriction{{0, 0, 0, 0.1, steepness_s_per_m, 0}};
  scene.contacts.push_back(wall);
  scene.displacement_m << 1e-3 + normal_n / stiffness, 0;
  run::SolverOptions options;
  options.stepper = stepper;
  options.relative_tolerance = 1e-7;
  const run::Cursor advance = adaptive::start_adaptive(scene, options);
  run::TurnRequest asked;
  run::TurnReport turn;
  constexpr int samples = 2000;
  asked.samples_per_revolution = samples;
  for (int k = 0; k < 40; ++k) EXPECT_EQ(advance(asked, turn), run::Outcome::ok);  // until the drift dies out
  double sum = 0;
  for (std::size_t j = 0; j < samples; ++j) sum += std::abs(turn.samples[4 * j + 3]);
  return normal_n * sum / samples * scene.length_scale_m * scene.speed_rad_per_s;
}

TEST(CoulombSliding, TanhLawApproachesThePublishedWearPower) {
  // Instead of sticking the mass creeps at about 1 / steepness, so the excess falls likewise.
  double excess = 1;
  for (const double steepness : {1e2, 1e3, 1e4, 1e5}) {
    const double now = mean_wear_power(steepness, run::Stepper::rosenbrock4) - published_w;
    EXPECT_GT(now, 0);
    EXPECT_LT(now, 0.2 * excess) << steepness;
    excess = now;
  }
  EXPECT_LT(excess, 4e-4);
}

TEST(CoulombSliding, ExplicitAndImplicitSteppersAgreeWhereTanhIsSteep) {
  EXPECT_NEAR(mean_wear_power(1e3, run::Stepper::dopri5), mean_wear_power(1e3, run::Stepper::rosenbrock4),
              1e-5);
}

}  // namespace
}  // namespace rubsweep::integrate
