#include "rubsweep/measurement/diagnose/answer/foreign_cause.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

namespace rubsweep::diagnose::answer {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

constexpr int turns = 30, samples_of_a_turn = 64;
constexpr double speed_hz = 37;

/// Unbalance of 1, and what `more` adds at a shaft angle in radians.
MotionLines lines(const std::function<Complex(double)>& more, bool plane = true) {
  std::vector<Complex> z;
  for (int k = 0; k < turns * samples_of_a_turn; ++k) {
    const double phi = 2 * pi * k / samples_of_a_turn;
    const Complex there = std::polar(1.0, phi) + 0.1 * std::polar(1.0, -phi) + more(phi);
    z.push_back(plane ? there : there.real());
  }
  response::spectrum::SpectrumWorkspace workspace;
  return lines_of(z, turns, 8, workspace);
}

ForeignQuestion two_probes() {
  return {.speed_hz = speed_hz, .natural_frequency_hz = 25, .probe_angle_deg = std::pair(0.0, 90.0)};
}

std::vector<ForeignCause> causes(const MotionLines& motion, const ForeignQuestion& question = two_probes()) {
  std::vector<ForeignCause> found;
  for (const ForeignSign& sign : foreign_signs(motion, question)) found.push_back(sign.cause);
  return found;
}

using Causes = std::vector<ForeignCause>;

TEST(ForeignCauseSigns, OfLinesFarAboveTheNaturalFrequencyIsASecondModeOfARotorThatHasOneModeHere) {
  // Impacts every second turn that a mode at 65 Hz answers: lines at 3/2 and 5/2.
  const auto rub = [](double phi) {
    return 0.1 * std::polar(1.0, phi / 2) + 0.4 * std::polar(1.0, 1.5 * phi) +
           0.3 * std::polar(1.0, -2.5 * phi);
  };
  ForeignQuestion question = two_probes();
  question.natural_frequency_hz = 23;
  EXPECT_EQ(causes(lines(rub), question), Causes{});
  question.one_mode = true;
  EXPECT_EQ(causes(lines(rub), question), Causes{ForeignCause::second_mode});
  EXPECT_NEAR(foreign_signs(lines(rub), question)[0].order, 1.5, 0.02);
  question.natural_frequency_hz = 0;
  EXPECT_EQ(causes(lines(rub), question), Causes{});
  question.natural_frequency_hz = 23;
  // One mode answers such impacts mostly at 1/2.
  EXPECT_EQ(causes(lines([](double phi) {
                     return 0.4 * std::polar(1.0, phi / 2) + 0.1 * std::polar(1.0, 1.5 * phi);
                   }),
                   question),
            Causes{});
}

TEST(ForeignCauseSigns, NoiseAloneIsNoSecondMode) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> noise(0, 0.12);
  ForeignQuestion question = two_probes();
  question.natural_frequency_hz = 10;
  question.one_mode = true;
  EXPECT_EQ(causes(lines([&](double) { return Complex(noise(random), noise(random)); }), question), Causes{});
}

TEST(ForeignCauseSigns, ThereAreNoneWithoutLinesOff1X) {
  EXPECT_EQ(causes(lines([](double) { return 0; })), Causes{});
  EXPECT_EQ(causes(lines([](double phi) { return 0.03 * std::polar(1.0, 2 * phi); })), Causes{});
}

TEST(ForeignCauseSigns, Of2XIsMisalignmentAndAtHalfTheCriticalSpeedACrack) {
  const auto twice = [](double phi) {
    return 0.4 * std::polar(1.0, 2 * phi) + 0.2 * std::polar(1.0, -2 * phi);
  };
  EXPECT_EQ(causes(lines(twice)), Causes{ForeignCause::misalignment});
  ForeignQuestion slow = two_probes();
  slow.natural_frequency_hz = 2.05 * speed_hz;
  EXPECT_EQ(causes(lines(twice), slow), (Causes{ForeignCause::misalignment, ForeignCause::cracked_shaft}));
  const auto sign = foreign_signs(lines(twice), two_probes());
  EXPECT_GT(sign[0].share, 0.99);
  EXPECT_EQ(sign[0].order, 2);
  EXPECT_EQ(causes(lines(twice, false), {.speed_hz = speed_hz}), Causes{ForeignCause::misalignment});
}

TEST(ForeignCauseSigns, OilWhirlIsForwardAndBelowHalf) {
  const auto whirl = [](double order) {
    return [order](double phi) { return 0.6 * std::polar(1.0, order * phi); };
  };
  EXPECT_EQ(causes(lines(whirl(0.44))), Causes{ForeignCause::oil_whirl});
  EXPECT_EQ(causes(lines(whirl(-0.44))), Causes{});
  EXPECT_EQ(causes(lines(whirl(0.5))), Causes{});
  EXPECT_EQ(causes(lines(whirl(25 / speed_hz))), Causes{ForeignCause::self_excited});
  EXPECT_EQ(causes(lines(whirl(0.8))), Causes{});
}

TEST(ForeignCauseSigns, MainsHumKeepsItsFrequency) {
  const auto hum = [](double hz) {
    return [hz](double phi) { return 0.5 * std::cos(hz / speed_hz * phi) * Complex(1, 0.6); };
  };
  EXPECT_EQ(causes(lines(hum(50))), Causes{ForeignCause::mains_hum});
  EXPECT_EQ(causes(lines(hum(60))), Causes{ForeignCause::mains_hum});
  EXPECT_EQ(causes(lines(hum(54))), Causes{});
  // At 25 rev/s 50 Hz is 2X.
  ForeignQuestion other = two_probes();
  other.speed_hz = 25;
  const auto at_2x = causes(lines([](double phi) { return 0.5 * std::cos(2 * phi); }), other);
  EXPECT_EQ(at_2x, Causes{ForeignCause::misalignment});
}

/// Readings of a profile of the surface by probes at these angles, as motion x + iy.
Complex profile(double phi, double first_deg, double second_deg) {
  const auto height = [](double angle) {
    return 0.3 * std::cos(2 * angle + 0.3) + 0.3 * std::cos(3 * angle + 1) + 0.2 * std::cos(4 * angle + 2) +
           0.2 * std::cos(5 * angle - 1);
  };
  const double a = first_deg * pi / 180, b = second_deg * pi / 180;
  const double first = height(phi - a), second = height(phi - b), sine = std::sin(b - a);
  return {(first * std::sin(b) - second * std::sin(a)) / sine,
          (second * std::cos(a) - first * std::cos(b)) / sine};
}

TEST(ForeignCauseSigns, RunOutIsSeenByTheSecondProbeLater) {
  ForeignQuestion question = two_probes();
  EXPECT_EQ(causes(lines([](double phi) { return profile(phi, 0, 90); })), Causes{ForeignCause::run_out});
  question.probe_angle_deg = {-45, 30};
  EXPECT_EQ(causes(lines([](double phi) { return profile(phi, -45, 30); }), question),
            Causes{ForeignCause::run_out});
  EXPECT_EQ(causes(lines([](double phi) { return profile(-phi, 0, 90); })), Causes{});
  // One probe tells it from a loose support as little as the other way round.
  const Causes one_probe =
      causes(lines([](double phi) { return profile(phi, 0, 90); }, false), {.speed_hz = speed_hz});
  EXPECT_EQ(one_probe.size(), 2U);
  EXPECT_EQ(std::ranges::count(one_probe, ForeignCause::run_out), 1);
  EXPECT_EQ(std::ranges::count(one_probe, ForeignCause::looseness), 1);
}

TEST(ForeignCauseSigns, LooseSupportsMoveTheShaftAlongALine) {
  const auto along = [](double phi, double spread) {
    return std::polar(0.3, 0.7) * std::cos(2 * phi) + std::polar(0.2, 0.7 + spread) * std::cos(3 * phi + 1) +
           std::polar(0.2, 0.7 - spread) * std::cos(4 * phi + 2) + std::polar(0.1, 0.7) * std::cos(0.5 * phi);
  };
  EXPECT_EQ(causes(lines([&](double phi) { return along(phi, 0); })), Causes{ForeignCause::looseness});
  EXPECT_EQ(causes(lines([&](double phi) { return along(phi, 1.2); })), Causes{});
}

TEST(ForeignCauseSigns, FaultyBearingsHaveAnOrderOfNoFraction) {
  const auto fault = [](double order) {
    return [order](double phi) {
      return (0.3 * std::cos(order * phi) + 0.2 * std::cos(2 * order * phi)) * (1 + 0.5 * std::cos(phi)) *
             std::polar(1.0, 0.4);
    };
  };
  EXPECT_EQ(causes(lines(fault(3.57))), Causes{ForeignCause::bearing_fault});
  EXPECT_EQ(causes(lines(fault(3.1))), Causes{ForeignCause::bearing_fault});
  EXPECT_EQ(causes(lines(fault(2.5))), Causes{});
  EXPECT_EQ(causes(lines(fault(0.62))), Causes{});
}

}  // namespace
}  // namespace rubsweep::diagnose::answer
