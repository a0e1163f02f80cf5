#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "rubsweep/core/integrate/adaptive/start_adaptive.hpp"
#include "rubsweep/core/integrate/adaptive/stepper_table.hpp"
#include "support/annular_scene.hpp"
#include "support/simple_scenes.hpp"

namespace rubsweep::integrate {
namespace {

using Complex = std::complex<double>;
using test::annular_scene;
using test::FullRub;
using test::start_at;
constexpr Complex i{0, 1};
using std::numbers::pi;

Complex position(const std::vector<double>& states, std::size_t row = 0) {
  return {states[4 * row], states[4 * row + 1]};
}

/// Peak-to-peak amplitudes of the vertical motion at these orders, over 64 turns after 300 turns.
std::vector<double> vertical_lines(const scene::Scene& scene, const std::vector<double>& orders) {
  constexpr int samples = 128, turns = 64;
  const run::Cursor advance = adaptive::start_adaptive(scene, {});
  run::TurnRequest asked;
  run::TurnReport turn;
  for (int k = 0; k < 300; ++k) EXPECT_EQ(advance(asked, turn), run::Outcome::ok);
  asked.samples_per_revolution = samples;
  std::vector<Complex> sums(orders.size());
  for (int k = 0; k < turns; ++k) {
    EXPECT_EQ(advance(asked, turn), run::Outcome::ok);
    for (int j = 0; j < samples; ++j) {
      const double y = position(turn.samples, static_cast<std::size_t>(j)).imag();
      for (std::size_t m = 0; m < orders.size(); ++m) {
        sums[m] += y * std::exp(-i * (2 * pi * orders[m] * (k + double(j) / samples)));
      }
    }
  }
  std::vector<double> peak_to_peak;
  for (const Complex& sum : sums) peak_to_peak.push_back(4 * std::abs(sum) / (samples * turns));
  return peak_to_peak;
}

// Three published responses of a rotor that sags onto an annular stop (k_c = 40, zeta = 0.05).
TEST(AnnularStopWithSag, HalfSubharmonicAtOnceTheSpeed) {
  auto scene = annular_scene(1, 0.05, 2.6, 0.16, -0.7 * i, 40, 0.05);
  start_at(scene, -0.7 * i, 0);
  const auto lines = vertical_lines(scene, {0.5, 1});
  EXPECT_NEAR(lines[0], 1.32, 0.005);
  EXPECT_NEAR(lines[1], 0.25, 0.005);
}

TEST(AnnularStopWithSag, HalfAndThreeHalvesFromRestOnTheRing) {
  auto scene = annular_scene(0.3, 0.05, 1.4, 0.8, -1.2 * i, 40, 0);
  start_at(scene, -41.2 / 40.3 * i, 0);  // 0.3 y + 40 (y - 1) = 1.2
  const auto lines = vertical_lines(scene, {0.5, 1.5});
  EXPECT_NEAR(lines[0], 1.11, 0.005);
  EXPECT_NEAR(lines[1], 1.00, 0.005);
}

TEST(AnnularStopWithSag, FrictionThrowsTheRotorOutwards) {
  auto scene = annular_scene(1, 0.05, 2.3, 0.25, -0.7 * i, 40, 0.15);
  start_at(scene, -0.7 * i, 0);
  const run::Cursor advance = adaptive::start_adaptive(scene, {});
  run::TurnRequest asked;
  run::TurnReport turn;
  asked.peaks = true;
  for (int k = 1; k <= 12; ++k) {
    ASSERT_EQ(advance(asked, turn), run::Outcome::ok);
    EXPECT_EQ(turn.peak_displacement_m > 1.8, k > 11) << "turn " << k;
  }
}

TEST(AnnularFullRub, StaysOnItsClosedForm) {
  for (const run::Stepper stepper : adaptive::single_steppers()) {
    const FullRub rub;
    run::SolverOptions options;
    options.stepper = stepper;
    options.relative_tolerance = 1e-9;
    const run::Cursor advance = adaptive::start_adaptive(rub.scene(), options);
    run::TurnRequest asked;
    run::TurnReport turn;
    asked.samples_per_revolution = 16;
    asked.peaks = true;
    for (int k = 0; k < 20; ++k) {
      ASSERT_EQ(advance(asked, turn), run::Outcome::ok);
      EXPECT_NEAR(turn.contact_fraction, 1, 1e-12);
      for (std::size_t j = 0; j < 16; ++j) EXPECT_NEAR(std::abs(position(turn.samples, j)), rub.radius, 1e-6);
      EXPECT_NEAR(turn.peak_contact_force_n, rub.k_c * (rub.radius - 1), 1e-5);
    }
  }
}

TEST(AnnularFullRub, IsReachedFromNearby) {
  const FullRub rub;
  auto scene = rub.scene();
  scene.displacement_m *= 1.02;
  const run::Cursor advance = adaptive::start_adaptive(scene, {});
  run::TurnReport turn;
  for (int k = 0; k < 60; ++k) ASSERT_EQ(advance({}, turn), run::Outcome::ok);
  EXPECT_NEAR(std::abs(position(turn.section)), rub.radius, 1e-6);
}

TEST(AnnularDryWhip, WhirlsBackwardAtItsClosedFormFrequency) {
  // Circular dry whip without unbalance: w = zeta/mu + sqrt((zeta/mu)^2 + 1), r = 1 / (1 - 2 zeta w / (mu
  // b)), for mu > 2 zeta sqrt(1 + b) / b.
  const double zeta = 0.05, mu = 0.2, b = 20;
  ASSERT_GT(mu, 2 * zeta * std::sqrt(1 + b) / b);
  const double w = zeta / mu + std::sqrt(zeta * zeta / (mu * mu) + 1);
  const double radius = 1 / (1 - 2 * zeta * w / (mu * b));
  auto scene = annular_scene(1, zeta, 1, 0, 0, b, mu);
  start_at(scene, radius, -i * w * radius);
  run::SolverOptions options;
  options.relative_tolerance = 1e-10;
  const run::Cursor advance = adaptive::start_adaptive(scene, options);
  run::TurnReport turn;
  for (int k = 1; k <= 5; ++k) {
    ASSERT_EQ(advance({}, turn), run::Outcome::ok);
    EXPECT_LT(std::abs(position(turn.section) - radius * std::exp(-i * (2 * pi * w * k))), 1e-6);
  }
}

TEST(AnnularDryWhip, FeedsItselfOnlyAboveItsLeastFriction) {
  // Deep in the annular stop z'' + 2 zeta z' + (1 + b (1 + i mu)) z = const. A backward whirl grows when mu >
  // 2 zeta sqrt(1 + b) / b.
  const double zeta = 0.05, b = 20, least = 2 * zeta * std::sqrt(1 + b) / b, whirl = std::sqrt(1 + b);
  for (const double share : {0.9, 1.1}) {
    auto scene = annular_scene(1, zeta, 1, 0, 0, b, share * least);
    start_at(scene, 1e4, -i * whirl * 1e4);
    const run::Cursor advance = adaptive::start_adaptive(scene, {});
    run::TurnReport turn;
    for (int k = 0; k < 10; ++k) ASSERT_EQ(advance({}, turn), run::Outcome::ok);
    // The forward whirl dies out; |z| of the backward whirl changes as e^{(mu b / (2 whirl) - zeta) t}.
    const double rate = share * least * b / (2 * whirl) - zeta;
    EXPECT_NEAR(std::log(std::abs(position(turn.section)) / 1e4) / (20 * pi), rate, 0.05 * std::abs(rate))
        << share;
  }
}

TEST(AnnularStop, OffsetMovesTheWall) {
  // A slow rotor, offset by 0.6 towards +x in an annular stop of radius 1, moves outwards: it touches at x =
  // 0.4 or, in the other direction, at x = -1.6.
  for (const int sign : {1, -1}) {
    auto scene = test::one_mass_scene(1, 1e-6, 0, 1, 1);
    scene::Contact stop;
    stop.wall = contact::AnnularWall{{0.6, 0}};
    stop.clearance_m = 1;
    stop.stiffness_n_per_m = 1e4;
    scene.contacts.push_back(stop);
    scene.velocity_m_per_s << sign * 2.0, 0;
    const run::Cursor advance = adaptive::start_adaptive(scene, {});
    run::TurnRequest asked;
    run::TurnReport turn;
    asked.switches = true;
    ASSERT_EQ(advance(asked, turn), run::Outcome::ok);
    ASSERT_FALSE(turn.switches.empty());
    EXPECT_NEAR(turn.switches[0].phase_rad / (2 * pi), (sign > 0 ? 0.4 : 1.6) / 2.0, 1e-6);
  }
}

TEST(AnnularStop, PassingThroughTheCentreIsHarmless) {
  auto scene = test::one_mass_scene(1, 40, 0, 1, 1);
  scene::Contact stop;
  stop.wall = contact::AnnularWall{};
  stop.clearance_m = 1;
  stop.stiffness_n_per_m = 1e4;
  scene.contacts.push_back(stop);
  scene.velocity_m_per_s << 3, 0;  // amplitude 0.47 on a straight line through d = 0
  for (const auto contact : {run::ContactHandling::located, run::ContactHandling::smoothed}) {
    run::SolverOptions options;
    options.contact = contact;
    const run::Cursor advance = adaptive::start_adaptive(scene, options);
    run::TurnReport turn;
    for (int k = 1; k <= 20; ++k) ASSERT_EQ(advance({}, turn), run::Outcome::ok);
    EXPECT_FALSE(turn.touched);
    EXPECT_NEAR(turn.section[0], 3 / std::sqrt(40) * std::sin(std::sqrt(40) * 20), 1e-5);
  }
}

}  // namespace
}  // namespace rubsweep::integrate
