#include "rubsweep/core/response/motion/classify.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "core/response/recording.hpp"
#include "core/response/synthetic_motion.hpp"
#include "rubsweep/core/error.hpp"

namespace rubsweep::response::testing {
namespace {

/// Generator of deterministic numbers in [-0.5, 0.5).
auto uniform_noise(unsigned seed) {
  return
      [bits = std::mt19937_64(seed)]() mutable { return static_cast<double>(bits() >> 11) * 0x1p-53 - 0.5; };
}

void expect_undecided(const Recording& recording) {
  const auto verdict = recording.verdict();
  EXPECT_EQ(to_string(verdict.motion_class), "unsettled");
  EXPECT_FALSE(verdict.order);
  EXPECT_FALSE(verdict.period);
  EXPECT_TRUE(verdict.spectrum_agrees);
  EXPECT_EQ(verdict.measures.turns, turns);
}

void expect_disagreement(const Recording& recording, int section_order) {
  const auto verdict = recording.verdict();
  EXPECT_EQ(to_string(verdict.motion_class), "unsettled");
  EXPECT_FALSE(verdict.order);
  ASSERT_TRUE(verdict.period);
  EXPECT_EQ(verdict.period->order, section_order);
  EXPECT_FALSE(verdict.spectrum_agrees);
  EXPECT_EQ(to_string(motion::settle_verdict(verdict, verdict).motion_class), "unsettled");
  EXPECT_EQ(to_string(motion::settle_verdict(verdict, verdict).status), "spectrum_disagrees");
}

TEST(Classify, NoContactAtAllIsNonContactWithoutOrder) {
  auto quiet = record(circle(0.4 * clearance_m));
  quiet.contact.assign(turns, {.peak_displacement_m = 0.4 * clearance_m});
  const auto verdict = quiet.verdict();
  EXPECT_EQ(to_string(verdict.motion_class), "non_contact");
  EXPECT_FALSE(verdict.order);
  EXPECT_FALSE(verdict.period);
  EXPECT_NEAR(verdict.measures.amplitude_1x_forward_m, 0.4 * clearance_m, 1e-15);
  EXPECT_NEAR(verdict.measures.amplitude_1x_backward_m, 0, 1e-15);
  EXPECT_EQ(verdict.measures.orbit, spectrum::OrbitKind::circle);
  EXPECT_EQ(verdict.measures.contact.peak_displacement_m, 0.4 * clearance_m);
}

TEST(Classify, SlidingAllAlongWithoutAHitIsContact) {
  auto sliding = record(circle(1.01 * clearance_m));
  sliding.contact.assign(turns, {.contact_fraction = 1});
  EXPECT_EQ(to_string(sliding.verdict().motion_class), "synchronous");
}

TEST(Classify, PressedOnAStopAndAtRestIsNoMotion) {
  const auto pressed = [](double size_m) {
    auto recording = record([size_m](double turn) {
      return std::complex(size_m * std::cos(2 * std::numbers::pi * turn), -clearance_m);
    });
    recording.contact.assign(turns, {.contact_fraction = 1});
    return recording.verdict();
  };
  for (const double size_m : {0.0, 1e-7 * clearance_m}) {
    EXPECT_EQ(to_string(pressed(size_m).motion_class), "resting_contact") << size_m;
    EXPECT_EQ(pressed(size_m).order, 1);
    EXPECT_FALSE(pressed(size_m).measures.dominant);
  }
  EXPECT_EQ(to_string(pressed(1e-5 * clearance_m).motion_class), "synchronous");
}

TEST(Classify, OneGrazeIsContact) {
  auto graze = record(circle(clearance_m));
  graze.contact.assign(turns, {});
  graze.contact.back().hits = 1;
  EXPECT_EQ(to_string(graze.verdict().motion_class), "synchronous");
}

TEST(Classify, SynchronousMotionOfAnyShape) {
  const auto verdict = record([](double turn) {
                         return clearance_m * (Complex(0.1, -0.5) + 0.7 * phasor(1, turn) +
                                               0.2 * phasor(-2, turn) + 0.05 * phasor(5, turn));
                       }).verdict();
  EXPECT_EQ(to_string(verdict.motion_class), "synchronous");
  EXPECT_EQ(verdict.order, 1);
  EXPECT_LT(verdict.period->residual, 1e-10);
  EXPECT_TRUE(verdict.spectrum_agrees);
  EXPECT_LT(*verdict.off_order_energy_fraction, 1e-20);
  EXPECT_EQ(verdict.measures.dominant->order, 1);
  EXPECT_NEAR(verdict.measures.dominant->amplitude_m, 0.7 * clearance_m, 1e-15);
  EXPECT_EQ(verdict.measures.orbit, spectrum::OrbitKind::complex);
  EXPECT_EQ(verdict.measures.whirl, spectrum::WhirlKind::forward);
}

TEST(Classify, EverySubharmonicUpToTheLargestOrder) {
  for (int n = 2; n <= 12; ++n) {
    SCOPED_TRACE(n);
    const auto verdict = record(subharmonic(n, -0.8), 1000).verdict();
    EXPECT_EQ(to_string(verdict.motion_class), "subharmonic");
    EXPECT_EQ(verdict.order, n);
    EXPECT_EQ(verdict.measures.turns, motion::window_turns(turns, n));
    EXPECT_LT(*verdict.off_order_energy_fraction, 1e-20);
    EXPECT_DOUBLE_EQ(verdict.measures.dominant->order, 1.0 / n);
    EXPECT_NEAR(verdict.measures.dominant->amplitude_m, 0.8 * clearance_m, 1e-14);
    EXPECT_NEAR(verdict.measures.amplitude_1x_forward_m, 0.6 * clearance_m, 1e-14);
  }
  expect_undecided(record(subharmonic(13)));
}

TEST(Classify, BackwardSubharmonicHasANegativeDominantOrder) {
  const auto verdict = record([](double turn) {
                         return clearance_m * (0.2 * phasor(1, turn) + 0.9 * phasor(-1.5, turn));
                       }).verdict();
  EXPECT_EQ(verdict.order, 2);
  EXPECT_EQ(verdict.measures.dominant->order, -1.5);
  EXPECT_EQ(verdict.measures.whirl, spectrum::WhirlKind::backward);
}

TEST(Classify, UsesTheLastTurnsOfTheWindow) {
  // Order 7 fits 9 times into 64 turns, so the first turn is not used.
  auto recording = record(subharmonic(7));
  for (std::size_t j = 0; j < per_turn; ++j) recording.displacement_m[j] = 5 * clearance_m;
  recording.section_rows[0] = 5;
  EXPECT_EQ(recording.verdict().order, 7);
}

TEST(Classify, ASectionThatReturnsWhileTheSamplesDoNotIsADisagreement) {
  auto recording = record(circle(0.9 * clearance_m));
  recording.displacement_m = record(subharmonic(2)).displacement_m;
  expect_disagreement(recording, 1);
  recording = record(subharmonic(3));
  recording.displacement_m = record(subharmonic(4)).displacement_m;
  expect_disagreement(recording, 3);
}

/// A circle of radius 0.9 clearance as section and samples; the samples have one more line.
Recording circle_with_line(double order, double amplitude_m, Complex mean_m = 0) {
  auto recording = record(circle(0.9 * clearance_m));
  recording.displacement_m = sample(
      [=](double turn) {
        return mean_m + 0.9 * clearance_m * phasor(1, turn) + amplitude_m * phasor(order, turn);
      },
      0, turns, per_turn);
  return recording;
}

TEST(Classify, OneLineOffTheOrdersDisagreesAboveAThousandthOfTheLargest) {
  EXPECT_EQ(circle_with_line(0.5, 0.9e-3 * 0.9 * clearance_m).verdict().order, 1);
  const auto significant = circle_with_line(0.5, 1.1e-3 * 0.9 * clearance_m);
  EXPECT_LT(*significant.verdict().off_order_energy_fraction, 1e-4);
  expect_disagreement(significant, 1);
}

TEST(Classify, InSmallMotionsAMillionthOfTheClearanceIsSignificant) {
  const auto small_circle_with_line = [](double amplitude_m) {
    auto recording = record(circle(5e-4 * clearance_m));
    const auto line = sample({{1, 2, amplitude_m}}, turns, per_turn);
    for (std::size_t j = 0; j < line.size(); ++j) recording.displacement_m[j] += line[j];
    return recording;
  };
  EXPECT_EQ(small_circle_with_line(0.9e-6 * clearance_m).verdict().order, 1);
  expect_disagreement(small_circle_with_line(1.1e-6 * clearance_m), 1);
}

TEST(Classify, AStaticDeflectionHidesNothing) {
  expect_disagreement(circle_with_line(0.5, 1.1e-3 * 0.9 * clearance_m, 100 * clearance_m), 1);
}

TEST(Classify, BroadbandEnergyDisagreesThoughNoLineIsSignificant) {
  // White noise with 3e-4 of the circle's mean square: each of the 8192 lines has about 2e-4 of the largest
  // one.
  auto recording = record(circle(0.9 * clearance_m));
  auto random = uniform_noise(7);
  const auto with_noise = [&](double energy) {
    auto noisy = recording;
    const double side_m = std::sqrt(6 * energy) * 0.9 * clearance_m;
    for (auto& z : noisy.displacement_m) z += side_m * Complex(random(), random());
    return noisy;
  };
  const auto loud = with_noise(3e-4);
  EXPECT_NEAR(*loud.verdict().off_order_energy_fraction, 3e-4, 2e-5);
  expect_disagreement(loud, 1);
  auto deflected = loud;
  for (auto& z : deflected.displacement_m) z += 100 * clearance_m;
  expect_disagreement(deflected, 1);
  EXPECT_EQ(with_noise(0.5e-4).verdict().order, 1);
}

TEST(Classify, ARotorPressedToTheWallAtRestIsSynchronousWithoutOrbit) {
  auto random = uniform_noise(3);
  auto recording = record([](double) { return Complex(0, 1.001 * clearance_m); });
  for (auto& z : recording.displacement_m) z += 1e-19 * Complex(random(), random());
  const auto verdict = recording.verdict();
  EXPECT_EQ(verdict.order, 1);
  EXPECT_FALSE(verdict.measures.dominant);
  EXPECT_FALSE(verdict.measures.orbit);
  EXPECT_FALSE(verdict.measures.whirl);
}

TEST(Classify, QuasiPeriodicMotionIsLeftUndecided) {
  expect_undecided(record([](double turn) {
    return clearance_m * (0.6 * phasor(1, turn) + 0.5 * phasor(1 / std::numbers::phi, turn));
  }));
  // Undecided even for a near miss: a line at order 0.501 drifts by 0.4 degrees per turn relative to 1/2.
  expect_undecided(
      record([](double turn) { return clearance_m * (0.6 * phasor(1, turn) + 0.5 * phasor(0.501, turn)); }));
}

TEST(Classify, WhiteNoiseIsLeftUndecided) {
  auto random = uniform_noise(1);
  Recording recording;
  for (int j = 0; j < turns * per_turn; ++j) {
    recording.displacement_m.push_back(clearance_m * Complex(random(), random()));
  }
  for (int j = 0; j < (turns + 1) * 4; ++j) recording.section_rows.push_back(random());
  expect_undecided(recording);
}

TEST(Classify, ChaoticAmplitudesAreLeftUndecided) {
  // One amplitude per turn from a chaotic map, connected smoothly within the turn.
  std::vector<double> logistic = {0.4};
  std::vector<double> henon = {0.1, 0.2};
  for (int k = 0; k < 200; ++k) {
    logistic.push_back(3.9 * logistic.back() * (1 - logistic.back()));
    const double x = henon.back();
    henon.push_back(1 - 1.4 * x * x + 0.3 * henon[henon.size() - 2]);
  }
  for (const auto& amplitude : {logistic, henon}) {
    expect_undecided(record(
        [&amplitude](double turn) {
          const auto k = static_cast<std::size_t>(std::floor(turn));
          const double blend = 0.5 - 0.5 * std::cos(std::numbers::pi * (turn - std::floor(turn)));
          return clearance_m * (amplitude[k] + blend * (amplitude[k + 1] - amplitude[k])) * phasor(1, turn);
        },
        50));
  }
}

TEST(Classify, ASlowDecayIsUndecidedUntilItIsOver) {
  const TimeFunction decay = [](double turn) {
    return clearance_m * (1 + 0.05 * std::exp(-0.01 * turn)) * phasor(1, turn);
  };
  expect_undecided(record(decay));
  expect_undecided(record(decay, 300));
  EXPECT_EQ(record(decay, 600).verdict().order, 1);
}

TEST(Classify, PerturbationsOfTheSectionDecideAtTenToTheMinusFive) {
  auto recording = record(subharmonic(3));
  recording.section_rows[120] += 5e-6;
  EXPECT_EQ(recording.verdict().order, 3);
  recording.section_rows[120] += 15e-6;
  expect_undecided(recording);
}

TEST(Classify, RefusesWindowsWhoseSizesDoNotMatch) {
  spectrum::SpectrumWorkspace workspace;
  const auto recording = record(circle(clearance_m));
  const auto refuses = [&](auto&& change) {
    motion::Window window = recording.window();
    change(window);
    EXPECT_THROW(motion::classify_window(window, {}, workspace), SolverError);
  };
  refuses([](motion::Window& window) { window.turns = 63; });
  refuses([](motion::Window& window) { window.turns = 0; });
  refuses([](motion::Window& window) { window.samples_per_revolution = 3; });
  refuses([](motion::Window& window) { window.states = 5; });
  refuses([](motion::Window& window) { window.clearance_m = 0; });
  refuses([](motion::Window& window) { window.section = window.section.first(window.section.size() - 4); });
}

TEST(ClassifySettleVerdict, WindowsThatAgreeDecide) {
  for (const int n : {1, 2, 12}) {
    const auto previous = record(subharmonic(n)).verdict();
    auto last = record(subharmonic(n), turns).verdict();
    last.measures.contact.hits = 77;
    const motion::Motion motion = motion::settle_verdict(previous, last);
    EXPECT_EQ(motion.motion_class,
              n == 1 ? motion::MotionClass::synchronous : motion::MotionClass::subharmonic);
    EXPECT_EQ(motion.order, n);
    EXPECT_EQ(to_string(motion.status), "ok");
    EXPECT_EQ(motion.measures.contact.hits, 77);
    EXPECT_EQ(motion.measures.turns, motion::window_turns(turns, n));
  }
}

TEST(ClassifySettleVerdict, WindowsThatDifferInClassOrOrderAreUnsettled) {
  auto quiet_recording = record(circle(0.4 * clearance_m));
  quiet_recording.contact.assign(turns, {});
  const auto quiet = quiet_recording.verdict();
  const auto one = record(circle(clearance_m)).verdict();
  const auto two = record(subharmonic(2)).verdict();
  const auto three = record(subharmonic(3)).verdict();
  EXPECT_EQ(motion::settle_verdict(quiet, quiet).motion_class, motion::MotionClass::non_contact);
  for (const auto& [previous, last] : {std::pair{quiet, one}, {one, quiet}, {one, two}, {two, three}}) {
    const motion::Motion motion = motion::settle_verdict(previous, last);
    EXPECT_EQ(motion.motion_class, motion::MotionClass::unsettled);
    EXPECT_FALSE(motion.order);
    EXPECT_EQ(to_string(motion.status), "ok");
  }
}

TEST(ClassifySettleVerdict, ADisagreementInEitherWindowIsNamed) {
  const auto good = record(circle(clearance_m)).verdict();
  const auto bad = circle_with_line(0.5, 0.1 * clearance_m).verdict();
  for (const auto& motion : {motion::settle_verdict(good, bad), motion::settle_verdict(bad, good)}) {
    EXPECT_EQ(motion.motion_class, motion::MotionClass::unsettled);
    EXPECT_EQ(motion.status, motion::MotionStatus::spectrum_disagrees);
  }
}

}  // namespace
}  // namespace rubsweep::response::testing
