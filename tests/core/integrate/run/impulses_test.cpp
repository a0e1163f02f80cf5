#include "rubsweep/core/integrate/run/impulses.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "rubsweep/core/integrate/adaptive/start_adaptive.hpp"
#include "rubsweep/core/integrate/hybrid_run.hpp"
#include "support/set_a_cell.hpp"
#include "support/simple_scenes.hpp"

namespace rubsweep::integrate::run {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

constexpr double mass_kg = 2, stiffness = 800, damping = 3, revolution_s = 0.7, impulse_ns = 0.05;

/// A damped oscillator with impulses along x.
scene::Scene struck_oscillator(double multiple, double phase_periods) {
  auto scene = test::one_mass_scene(mass_kg, stiffness, damping, revolution_s, 1e-3);
  scene.impulses.push_back({Eigen::Vector2d(impulse_ns, 0), multiple, phase_periods});
  return scene;
}

/// A rubbing rotor whose disc also gets impulses.
scene::Scene struck_rub(double multiple, double phase_periods) {
  scene::Scene scene = test::cell_of({}).scene;
  Eigen::VectorXd impulse = Eigen::VectorXd::Zero(4);
  impulse << 0.01, 0.04, 0, 0;
  scene.impulses.push_back({impulse, multiple, phase_periods});
  return scene;
}

/// Eigenvalue lambda of the oscillator: an impulse J causes the displacement J / (m Im lambda) Im e^{lambda
/// t}.
Complex eigenvalue() {
  const double decay = damping / (2 * mass_kg);
  return {-decay, std::sqrt(stiffness / mass_kg - decay * decay)};
}

std::vector<double> phases_of(Impulses& impulses, long revolution) {
  std::vector<double> phases;
  impulses.begin_turn(revolution);
  while (std::isfinite(impulses.next_phase_rad())) {
    phases.push_back(impulses.next_phase_rad());
    impulses.take();
  }
  return phases;
}

/// Applies all impulses up to a phase at once; they change only velocities, in units of the state.
TEST(Impulses, AreTakenUpToAPhase) {
  const scene::Scene scene = struck_oscillator(3.0, 0.1);
  Impulses impulses(scene);
  impulses.begin_turn(0);
  const StateScale scale = state_scale(scene);
  const double jump = impulse_ns / mass_kg / scale.unit_velocity_m_per_s();
  std::vector<double> state{1, 2, 3, 4, 5};
  const double first = impulses.next_phase_rad();
  const auto take_up_to = [&](double phase_rad) {
    while (phase_rad >= impulses.next_phase_rad()) add_impulse(impulses.take(), scale, state);
  };
  take_up_to(first - 1e-9);
  EXPECT_EQ(state, (std::vector<double>{1, 2, 3, 4, 5}));
  take_up_to(first + 2 * pi / 3 + 1e-9);
  EXPECT_NEAR(state[2], 3 + 2 * jump, 1e-12);
  EXPECT_EQ((std::vector<double>{state[0], state[1], state[3], state[4]}), (std::vector<double>{1, 2, 4, 5}));
  EXPECT_NEAR(impulses.next_phase_rad(), first + 4 * pi / 3, 1e-9);
}

TEST(Impulses, ComeOnceAPeriodWhereverTheRevolutionsEnd) {
  for (const double multiple : {0.1, 1.0 / 3, 1.0, 2.5, 3.57, 7.0}) {
    for (const double phase_periods : {0.0, 0.3, 0.999}) {
      Impulses impulses(struck_oscillator(multiple, phase_periods));
      int count = 0;
      for (long revolution = 0; revolution < 2000; ++revolution) {
        for (const double phase : phases_of(impulses, revolution)) {
          ASSERT_GE(phase, 0);
          ASSERT_LT(phase, 2 * pi);
          const double turns = static_cast<double>(revolution) + phase / (2 * pi);
          ASSERT_NEAR(turns, (count + phase_periods) / multiple, 1e-11) << multiple << ' ' << revolution;
          ++count;
        }
      }
    }
  }
}

TEST(Impulses, RepeatToTheLastBitWhereAWholeNumberFitsIntoATurn) {
  scene::Scene scene = struck_oscillator(5, 0.3);
  scene.impulses.push_back({Eigen::Vector2d(0, 1), 2, 0.1});
  Impulses impulses(scene);
  const auto first = phases_of(impulses, 0);
  ASSERT_EQ(first.size(), 7u);
  EXPECT_TRUE(std::ranges::is_sorted(first));
  EXPECT_EQ(phases_of(impulses, 123456), first);
  EXPECT_TRUE(same_every_turn(scene));
  scene.impulses.push_back({Eigen::Vector2d(0, 1), 2.5, 0});
  EXPECT_FALSE(same_every_turn(scene));
}

/// Compares the state after whole turns with the sum of the responses to all earlier impulses.
void expect_closed_form(const TurnReport& turn, int turns, double multiple, double phase_periods,
                        double bound) {
  const Complex lambda = eigenvalue();
  Complex sum = 0;
  for (int k = 0; (k + phase_periods) / multiple < turns; ++k)
    sum += std::exp(lambda * (revolution_s * (turns - (k + phase_periods) / multiple)));
  const double scale = impulse_ns / (mass_kg * lambda.imag()) / 1e-3;
  EXPECT_NEAR(turn.section[0], scale * sum.imag(), bound);
  EXPECT_NEAR(turn.section[2], scale * (lambda * sum).imag() * revolution_s / (2 * pi), bound);
  EXPECT_EQ(turn.section[1], 0);
}

TEST(Impulses, MoveADampedOscillatorAsTheClosedFormSays) {
  for (const double multiple : {0.4, 1.0, 3.57, 12.0}) {
    for (const double phase_periods : {0.0, 0.25}) {
      const auto scene = struck_oscillator(multiple, phase_periods);
      exact::modes::ModeCache modes;
      const auto exact = start_hybrid(scene, {}, modes);
      const Cursor adaptive = adaptive::start_adaptive(scene, {.relative_tolerance = 1e-11});
      TurnReport a, b;
      for (int k = 1; k <= 7; ++k) {
        ASSERT_EQ(exact.advance({}, a), Outcome::ok);
        ASSERT_EQ(adaptive({}, b), Outcome::ok);
        expect_closed_form(a, k, multiple, phase_periods, 1e-12);
        expect_closed_form(b, k, multiple, phase_periods, 1e-8);
      }
      EXPECT_EQ(a.effort.taylor_turns + a.effort.adaptive_turns, 0);
    }
  }
}

TEST(Impulses, EndInTheGeometricSeriesWithALineAtTheMultiple) {
  constexpr double multiple = 3;
  constexpr int samples = 4096;
  exact::modes::ModeCache modes;
  const auto run = start_hybrid(struck_oscillator(multiple, 0), {}, modes);
  TurnRequest asked;
  TurnReport turn;
  for (int k = 0; k < 80; ++k) ASSERT_EQ(run.advance(asked, turn), Outcome::ok);
  asked.samples_per_revolution = samples;
  ASSERT_EQ(run.advance(asked, turn), Outcome::ok);
  const Complex lambda = eigenvalue();
  const double period_s = revolution_s / multiple, scale = impulse_ns / (mass_kg * lambda.imag()) / 1e-3;
  const Complex series = std::exp(lambda * period_s) / (1.0 - std::exp(lambda * period_s));
  EXPECT_NEAR(turn.section[0], scale * series.imag(), 1e-11);
  for (const int order : {0, 1, 2, 3, 4, 6}) {
    Complex line = 0;
    for (int k = 0; k < samples; ++k)
      line += turn.samples[static_cast<std::size_t>(4 * k)] *
              std::polar(1.0 / samples, -2 * pi * order * k / samples);
    const double w = 2 * pi * order / revolution_s;
    const Complex receptance = 1.0 / Complex(stiffness - mass_kg * w * w, damping * w);
    const Complex expected = order % 3 == 0 ? impulse_ns / period_s * receptance / 1e-3 : 0.0;
    EXPECT_LT(std::abs(line - expected), 2e-6) << order;
  }
}

TEST(Impulses, BothSolversAgreeInContact) {
  for (const double multiple : {1.0, 3.57}) {
    const auto scene = struck_rub(multiple, 0.2);
    exact::modes::ModeCache modes;
    const auto exact = start_hybrid(scene, {}, modes);
    const Cursor adaptive =
        adaptive::start_adaptive(scene, {.stepper = Stepper::rkf78, .relative_tolerance = 1e-12});
    const auto plain = start_hybrid(test::cell_of({}).scene, {}, modes);
    TurnReport a, b, without;
    int hits = 0;
    for (int k = 0; k < 10; ++k) {
      ASSERT_EQ(exact.advance({}, a), Outcome::ok);
      ASSERT_EQ(adaptive({}, b), Outcome::ok);
      ASSERT_EQ(plain.advance({}, without), Outcome::ok);
      hits += a.hits;
      EXPECT_EQ(a.hits, b.hits);
      for (std::size_t i = 0; i < a.section.size(); ++i) EXPECT_NEAR(a.section[i], b.section[i], 1e-8) << k;
    }
    EXPECT_GT(hits, 2);
    EXPECT_EQ(a.effort.taylor_turns + a.effort.adaptive_turns, 0);
    EXPECT_GT(std::abs(a.section[1] - without.section[1]), 1e-3);
  }
}

/// An impulse during contact changes the speed, and so the damper force of the wall, at once.
TEST(Impulses, ThatStrikeInContactChangeItsMode) {
  auto scene = test::one_mass_scene(1, 100, 0, 1, 1);
  scene.displacement_m << 1, 0;
  scene.velocity_m_per_s << 3, 0;
  scene.contacts.push_back(test::wall_across_x(1, 0.9, 1e3, 20));
  scene.impulses.push_back({Eigen::Vector2d(8, 0), 5, 0.01});
  scene.impulses.push_back({Eigen::Vector2d(-20, 0), 5, 0.012});
  exact::modes::ModeCache modes;
  const auto exact = start_hybrid(scene, {}, modes);
  const Cursor adaptive =
      adaptive::start_adaptive(scene, {.stepper = Stepper::rkf78, .relative_tolerance = 1e-12});
  TurnRequest asked;
  TurnReport a, b;
  asked.switches = true;
  ASSERT_EQ(exact.advance(asked, a), Outcome::ok);
  ASSERT_EQ(adaptive(asked, b), Outcome::ok);
  for (std::size_t i = 0; i < a.section.size(); ++i) EXPECT_NEAR(a.section[i], b.section[i], 1e-8);
  ASSERT_EQ(a.switches.size(), b.switches.size());
  bool at_an_impulse = false;
  for (std::size_t i = 0; i < a.switches.size(); ++i) {
    EXPECT_NEAR(a.switches[i].phase_rad, b.switches[i].phase_rad, 1e-8);
    EXPECT_EQ(a.switches[i].to, b.switches[i].to);
    at_an_impulse = at_an_impulse || a.switches[i].phase_rad == 2 * pi * (0.01 / 5) ||
                    a.switches[i].phase_rad == 2 * pi * (0.012 / 5);
  }
  EXPECT_TRUE(at_an_impulse);
}

TEST(Impulses, TransitionIsTheDerivativeOfTheSection) {
  auto scene = struck_rub(3, 0);
  exact::modes::ModeCache modes;
  const auto kicked = start_hybrid(scene, {}, modes);
  TurnRequest asked;
  TurnReport turn;
  kicked.advance(asked, turn);
  kicked.advance(asked, turn);
  const std::vector<double> start = turn.section;
  scene.pulses.clear();
  const auto run = start_hybrid(scene, {}, modes);
  const auto section_after = [&](std::vector<double> from, std::size_t j, double h) {
    from[j] += h;
    run.restart(from);
    run.advance(asked, turn);
    return turn.section;
  };
  asked.tangent_vectors.setIdentity(8, 8);
  section_after(start, 0, 0);
  ASSERT_GT(turn.hits, 0);
  const Eigen::MatrixXd transition = *turn.tangent_vectors.get();
  asked.tangent_vectors.resize(0, 0);
  constexpr double h = 1e-6;
  for (std::size_t j = 0; j < start.size(); ++j) {
    const auto above = section_after(start, j, h), below = section_after(start, j, -h);
    for (std::size_t i = 0; i < start.size(); ++i) {
      EXPECT_NEAR(transition(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)),
                  (above[i] - below[i]) / (2 * h), 2e-4)
          << i << ' ' << j;
    }
  }
}

}  // namespace
}  // namespace rubsweep::integrate::run
