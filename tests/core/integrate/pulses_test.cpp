#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "rubsweep/core/integrate/adaptive/start_adaptive.hpp"
#include "rubsweep/core/integrate/hybrid_run.hpp"
#include "support/set_a_cell.hpp"
#include "support/simple_scenes.hpp"

namespace rubsweep::integrate {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

constexpr double mass_kg = 2, stiffness = 800, damping = 3, revolution_s = 0.31, length_m = 1e-3;

struct HalfSine {
  double force_n = 0, start_s = 0, duration_s = 0;
};

/// Displacement and velocity of the oscillator, first at rest, under one half-sine pulse. During the pulse x
/// = Im(A (e^{i w t} - c1 e^{lambda t} - ...)) with the two eigenvalues of m x'' + c x' + k x, afterwards it
/// vibrates freely.
std::array<double, 2> response_to(const HalfSine& pulse, double t_s) {
  const double delta = damping / (2 * mass_kg), wd = std::sqrt(stiffness / mass_kg - delta * delta);
  const auto free = [&](double x0, double v0, double t) -> std::array<double, 2> {
    // x is the real part of (x0 + i (v0 + delta x0) / wd) e^{(-delta - i wd) t}
    const Complex z = Complex(x0, (v0 + delta * x0) / wd) * std::exp(Complex(-delta, -wd) * t);
    return {z.real(), (Complex(-delta, -wd) * z).real()};
  };
  const double since = t_s - pulse.start_s;
  if (since <= 0) return {0, 0};
  const double w = pi / pulse.duration_s;
  const Complex amplitude = Complex(0, -pulse.force_n) / Complex(stiffness - mass_kg * w * w, damping * w);
  const auto inside = [&](double t) -> std::array<double, 2> {
    const Complex z = amplitude * std::polar(1.0, w * t);
    const auto [x, v] = free(-amplitude.real(), -(Complex(0, w) * amplitude).real(), t);
    return {z.real() + x, (Complex(0, w) * z).real() + v};
  };
  if (since <= pulse.duration_s) return inside(since);
  const auto [x, v] = inside(pulse.duration_s);
  return free(x, v, since - pulse.duration_s);
}

scene::Scene oscillator(const std::vector<HalfSine>& pulses) {
  auto scene = test::one_mass_scene(mass_kg, stiffness, damping, revolution_s, length_m);
  for (const HalfSine& p : pulses)
    scene.pulses.push_back({Eigen::Vector2d(1, 0), p.force_n, p.duration_s, -p.start_s});
  return scene;
}

/// Overlapping pulses, consecutive pulses in one turn, long pulses over several turns, and pulses far apart.
/// A pulse that acts before the run begins is not included, because the closed form starts at rest.
const std::array<std::vector<HalfSine>, 5> cases{
    {{{.force_n = 0.9, .start_s = 0, .duration_s = 0.1},
      {.force_n = -0.7, .start_s = 0.04, .duration_s = 0.15}},
     {{.force_n = 0.9, .start_s = 0.02, .duration_s = 0.05},
      {.force_n = 0.5, .start_s = 0.2, .duration_s = 0.06}},
     {{.force_n = 0.4, .start_s = 0.1, .duration_s = 1.1},
      {.force_n = 0.6, .start_s = 0.5, .duration_s = 0.2}},
     {{.force_n = 0.9, .start_s = 0, .duration_s = 0.1},
      {.force_n = 0.9, .start_s = 1.05, .duration_s = 0.1}},
     {{.force_n = 0.3, .start_s = 0, .duration_s = 0.2},
      {.force_n = 0.3, .start_s = 0.1, .duration_s = 0.2},
      {.force_n = 0.3, .start_s = 0.15, .duration_s = 0.2},
      {.force_n = 0.3, .start_s = 0.2, .duration_s = 2 * revolution_s - 0.2}}}};

TEST(Pulses, OfAFreeOscillatorAddUpByTheClosedForm) {
  const run::TurnRequest samples{.samples_per_revolution = 64, .peaks = true};
  for (std::size_t which = 0; which < cases.size(); ++which) {
    const auto scene = oscillator(cases[which]);
    exact::modes::ModeCache modes;
    const auto exact = start_hybrid(scene, {}, modes);
    const run::Cursor adaptive = adaptive::start_adaptive(scene, {.relative_tolerance = 1e-12});
    run::TurnReport a, b;
    const double unit_speed = length_m * 2 * pi / revolution_s;
    for (int turn = 0; turn < 7; ++turn) {
      ASSERT_EQ(exact.advance(samples, a), run::Outcome::ok);
      ASSERT_EQ(adaptive(samples, b), run::Outcome::ok);
      for (std::size_t k = 0; k < 64; ++k) {
        const double t_s = revolution_s * (turn + static_cast<double>(k) / 64);
        double x = 0, v = 0;
        for (const HalfSine& pulse : cases[which]) {
          const auto [dx, dv] = response_to(pulse, t_s);
          x += dx, v += dv;
        }
        EXPECT_NEAR(a.samples[4 * k], x / length_m, 2e-12) << which << ' ' << turn << ' ' << k;
        EXPECT_NEAR(a.samples[4 * k + 2], v / unit_speed, 2e-12) << which << ' ' << turn << ' ' << k;
        EXPECT_NEAR(b.samples[4 * k], x / length_m, 1e-9) << which << ' ' << turn << ' ' << k;
      }
    }
    EXPECT_EQ(a.effort.taylor_turns + a.effort.adaptive_turns, 0);
    EXPECT_GT(a.section[0] * a.section[0] + a.section[2] * a.section[2], 1e-6);  // the rotor still moves
  }
}

/// A scene with the kick and a second pulse, which comes while the rotor bounces on its stop.
scene::Scene kicked_twice(double start_turns, double duration_turns, double force_n) {
  auto scene = test::cell_of({}).scene;
  scene::Pulse second = scene.pulses.front();
  second.force_n = force_n;
  second.elapsed_s = -start_turns * scene.period_s();
  second.duration_s = duration_turns * scene.period_s();
  scene.pulses.push_back(second);
  return scene;
}

TEST(Pulses, BothSolversAgreeInContact) {
  struct Second {
    double start_turns, duration_turns, force_n;
  };
  for (const auto& [start, duration, force_n] :
       {Second{0.1, 0.3, -150}, Second{0.6, 1.7, 90}, Second{3.25, 0.5, 200}, Second{2, 1, -120}}) {
    const auto scene = kicked_twice(start, duration, force_n);
    exact::modes::ModeCache modes;
    const auto exact = start_hybrid(scene, {}, modes);
    const run::Cursor adaptive = adaptive::start_adaptive(scene, {.relative_tolerance = 1e-12});
    const auto once = start_hybrid(test::cell_of({}).scene, {}, modes);
    const run::TurnRequest asked{.samples_per_revolution = 32, .peaks = true, .switches = true};
    run::TurnReport a, b, without;
    int hits = 0;
    for (int k = 0; k < 8; ++k) {
      ASSERT_EQ(exact.advance(asked, a), run::Outcome::ok);
      ASSERT_EQ(adaptive(asked, b), run::Outcome::ok);
      ASSERT_EQ(once.advance({}, without), run::Outcome::ok);
      hits += a.hits;
      EXPECT_EQ(a.hits, b.hits) << start << ' ' << k;
      for (std::size_t i = 0; i < a.section.size(); ++i)
        EXPECT_NEAR(a.section[i], b.section[i], 1e-7) << start << ' ' << k;
      for (std::size_t i = 0; i < a.samples.size(); ++i)
        EXPECT_NEAR(a.samples[i], b.samples[i], 1e-7) << start << ' ' << k;
      EXPECT_NEAR(a.peak_contact_force_n, b.peak_contact_force_n, 1e-4 * b.peak_contact_force_n);
      ASSERT_EQ(a.switches.size(), b.switches.size()) << start << ' ' << k;
      for (std::size_t i = 0; i < a.switches.size(); ++i)
        EXPECT_NEAR(a.switches[i].phase_rad, b.switches[i].phase_rad, 1e-7);
    }
    EXPECT_GT(hits, 1) << start;
    EXPECT_EQ(a.effort.taylor_turns + a.effort.adaptive_turns, 0);
    EXPECT_GT(std::abs(a.section[1] - without.section[1]), 1e-4) << start;
  }
}

/// Another solver that takes over during or before a pulse continues the same motion.
TEST(Pulses, GoOnWhereAnotherSolverTakesOver) {
  test::OneSideRotor rotor;
  rotor.contact_radius_m = 1e-3;
  rotor.friction_steepness_s_per_m = 5;
  auto scene = test::cell_of(rotor).scene;
  // The first turn is quiet; the kick comes in the second.
  scene.pulses.front().elapsed_s = -1.2 * scene.period_s();
  scene::Pulse second = scene.pulses.front();
  second.elapsed_s = -2.3 * scene.period_s();
  second.duration_s = 2.5 * scene.period_s();
  scene.pulses.push_back(second);
  exact::modes::ModeCache modes;
  for (const run::Stepper stepper : {run::Stepper::automatic, run::Stepper::dopri5}) {
    const auto mixed = start_hybrid(scene, {.stepper = stepper, .relative_tolerance = 1e-12}, modes);
    const run::Cursor adaptive = adaptive::start_adaptive(scene, {.relative_tolerance = 1e-12});
    run::TurnReport a, b;
    for (int k = 0; k < 8; ++k) {
      ASSERT_EQ(mixed.advance({}, a), run::Outcome::ok);
      ASSERT_EQ(adaptive({}, b), run::Outcome::ok);
    }
    const bool by_series = stepper == run::Stepper::automatic;
    const long away = by_series ? a.effort.taylor_turns : a.effort.adaptive_turns;
    EXPECT_GT(away, 0);
    EXPECT_LT(away, 8);
    EXPECT_EQ(by_series ? a.effort.adaptive_turns : a.effort.taylor_turns, 0);
    for (std::size_t i = 0; i < a.section.size(); ++i) EXPECT_NEAR(a.section[i], b.section[i], 1e-6);
  }
}

/// Two half-strength kicks act like one kick.
TEST(Pulses, HalvesOfAKickAreTheKick) {
  const auto whole = test::cell_of({}).scene;
  auto halves = whole;
  halves.pulses.front().force_n /= 2;
  halves.pulses.push_back(halves.pulses.front());
  exact::modes::ModeCache modes;
  const auto one = start_hybrid(whole, {}, modes), two = start_hybrid(halves, {}, modes);
  run::TurnReport a, b;
  for (int k = 0; k < 6; ++k) {
    ASSERT_EQ(one.advance({}, a), run::Outcome::ok);
    ASSERT_EQ(two.advance({}, b), run::Outcome::ok);
    for (std::size_t i = 0; i < a.section.size(); ++i) EXPECT_NEAR(a.section[i], b.section[i], 1e-11) << k;
  }
}

}  // namespace
}  // namespace rubsweep::integrate
