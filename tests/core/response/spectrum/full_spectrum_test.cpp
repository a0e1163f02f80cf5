#include "rubsweep/core/response/spectrum/full_spectrum.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <latch>
#include <numbers>
#include <numeric>
#include <random>
#include <thread>
#include <vector>

#include "core/response/synthetic_motion.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/response/motion/poincare_section.hpp"

namespace rubsweep::response::testing {
namespace {

spectrum::FullSpectrum spectrum_of(const std::vector<Complex>& z, int turns) {
  spectrum::SpectrumWorkspace workspace;
  return spectrum::full_spectrum(z, turns, workspace);
}

std::vector<Complex> noise(std::size_t count, unsigned seed) {
  std::mt19937_64 bits(seed);
  const auto uniform = [&bits] { return static_cast<double>(bits() >> 11) * 0x1p-53 - 0.5; };
  std::vector<Complex> z(count);
  for (auto& value : z) value = {uniform(), uniform()};
  return z;
}

/// Expects exactly these lines (k, amplitude), and nothing else above 1e-14.
void expect_lines(const spectrum::FullSpectrum& spectrum, const std::vector<std::pair<int, double>>& lines) {
  for (int k = spectrum.first_line(); k <= spectrum.last_line(); ++k) {
    double expected = 0;
    for (const auto& [line, amplitude] : lines) {
      if (line == k) expected = amplitude;
    }
    EXPECT_NEAR(spectrum.amplitude(k), expected, 1e-14) << "line " << k;
  }
}

TEST(FullSpectrum, ForwardCircleIsOneLineOfItsRadiusAtPlusOne) {
  const auto spectrum = spectrum_of(sample({{1, 1, Complex(0.6, 0.8)}}, 8, 16), 8);
  EXPECT_EQ(spectrum.turns, 8);
  EXPECT_EQ(spectrum.samples_per_revolution, 16);
  EXPECT_EQ(spectrum.first_line(), -64);
  EXPECT_EQ(spectrum.last_line(), 63);
  expect_lines(spectrum, {{8, 1.0}});
  EXPECT_EQ(spectrum.order(8), 1.0);
}

TEST(FullSpectrum, BackwardCircleIsOneLineAtMinusOne) {
  expect_lines(spectrum_of(sample({{-1, 1, 0.7}}, 8, 16), 8), {{-8, 0.7}});
}

TEST(FullSpectrum, StraightCosineIsHalfItsAmplitudeOnEitherSide) {
  std::vector<Complex> z(8 * 16);
  for (std::size_t j = 0; j < z.size(); ++j) z[j] = std::cos(2 * std::numbers::pi * double(j % 16) / 16);
  expect_lines(spectrum_of(z, 8), {{8, 0.5}, {-8, 0.5}});
}

TEST(FullSpectrum, EllipseWithOffsetSplitsIntoHalfSumHalfDifferenceAndMean) {
  // x = 0.9 cos, y = 0.3 sin: forward (0.9 + 0.3) / 2, backward (0.9 - 0.3) / 2.
  std::vector<Complex> z(8 * 16);
  for (std::size_t j = 0; j < z.size(); ++j) {
    const double angle = 2 * std::numbers::pi * double(j % 16) / 16;
    z[j] = Complex(3, -4) + Complex(0.9 * std::cos(angle), 0.3 * std::sin(angle));
  }
  const auto spectrum = spectrum_of(z, 8);
  expect_lines(spectrum, {{0, 5.0}, {8, 0.6}, {-8, 0.3}});
  EXPECT_NEAR(spectrum.energy_without_mean(), 0.45, 1e-14);
}

TEST(FullSpectrum, EverySubharmonicFallsExactlyIntoItsBin) {
  for (int n = 2; n <= 12; ++n) {
    const int turns = motion::window_turns(64, n);
    const auto spectrum =
        spectrum_of(sample({{1, 1, 0.5}, {1, n, Complex(0, 1)}, {-(n + 1), n, 0.25}}, turns, 128), turns);
    SCOPED_TRACE(n);
    const int m = turns / n;
    expect_lines(spectrum, {{turns, 0.5}, {m, 1.0}, {-(n + 1) * m, 0.25}});
  }
}

TEST(FullSpectrum, IsTheDirectSumForEvenAndOddLengths) {
  for (const auto& [turns, per_turn] : {std::pair{3, 20}, std::pair{3, 7}, std::pair{5, 4}}) {
    const auto z = noise(static_cast<std::size_t>(turns * per_turn), 11);
    const auto spectrum = spectrum_of(z, turns);
    const auto count = static_cast<long>(z.size());
    ASSERT_EQ(spectrum.last_line() - spectrum.first_line() + 1, count);
    for (int k = spectrum.first_line(); k <= spectrum.last_line(); ++k) {
      Complex sum = 0;
      for (long j = 0; j < count; ++j) {
        const double part = static_cast<double>((k * j) % count) / static_cast<double>(count);
        sum += z[static_cast<std::size_t>(j)] * std::polar(1.0, -2 * std::numbers::pi * part);
      }
      EXPECT_NEAR(spectrum.amplitude(k), std::abs(sum) / static_cast<double>(count), 1e-15) << k;
    }
  }
}

TEST(FullSpectrum, EnergyIsTheMeanSquareInTime) {
  const auto z = noise(64 * 128, 5);
  const auto spectrum = spectrum_of(z, 64);
  const double count = static_cast<double>(z.size());
  const Complex mean = std::accumulate(z.begin(), z.end(), Complex{}) / count;
  double square = 0;
  for (const auto& value : z) square += std::norm(value - mean);
  EXPECT_NEAR(spectrum.energy_without_mean(), square / count, 1e-13);
  EXPECT_NEAR(spectrum.amplitude(0), std::abs(mean), 1e-15);
}

TEST(FullSpectrum, ManyThreadsAtOnceGiveTheBitsOfOne) {
  // Lengths that no other test uses, so that threads also meet in FFTW's planner.
  constexpr int thread_count = 8;
  const std::vector<int> turns = {17, 31, 33, 38, 17, 33, 45, 31};
  const auto z = noise(45 * 64, 3);
  const auto run = [&z, &turns](std::size_t first) {
    spectrum::SpectrumWorkspace workspace;
    std::vector<std::vector<double>> found(turns.size());
    for (std::size_t i = 0; i < turns.size(); ++i) {
      const std::size_t which = (first + i) % turns.size();
      const auto count = static_cast<std::size_t>(turns[which]) * 64;
      found[which] = spectrum::full_spectrum(std::span(z).first(count), turns[which], workspace).amplitude_m;
    }
    return found;
  };

  std::vector<std::vector<std::vector<double>>> found(thread_count);
  std::latch start(thread_count);
  std::vector<std::jthread> threads;
  for (std::size_t t = 0; t < thread_count; ++t) {
    threads.emplace_back([&, t] {
      start.arrive_and_wait();
      found[t] = run(t);
    });
  }
  threads.clear();
  const auto alone = run(0);
  for (const auto& one : found) EXPECT_TRUE(one == alone);
}

TEST(FullSpectrum, DominantLineIgnoresTheMeanAndPrefersForwardAmongEqualTwins) {
  EXPECT_EQ(spectrum::dominant_line(spectrum_of(sample({{0, 1, 9.0}, {-1, 2, 0.6}, {1, 1, 0.5}}, 8, 16), 8)),
            -4);
  EXPECT_EQ(spectrum::dominant_line(spectrum_of(sample({{-2, 1, 0.5}, {2, 1, 0.5 * (1 - 1e-12)}}, 8, 16), 8)),
            16);
  EXPECT_EQ(spectrum::dominant_line(spectrum_of(sample({{-2, 1, 0.5}, {2, 1, 0.5 * (1 - 1e-6)}}, 8, 16), 8)),
            -16);
}

TEST(FullSpectrum, RefusesSamplesThatDoNotFillTheTurnsAndLinesThatDoNotExist) {
  spectrum::SpectrumWorkspace workspace;
  const std::vector<Complex> z(10);
  EXPECT_THROW(spectrum::full_spectrum(z, 3, workspace), SolverError);
  EXPECT_THROW(spectrum::full_spectrum(z, 0, workspace), SolverError);
  EXPECT_THROW(spectrum::full_spectrum({}, 1, workspace), SolverError);
  const auto spectrum = spectrum::full_spectrum(z, 5, workspace);
  EXPECT_THROW(spectrum.amplitude(5), SolverError);
  EXPECT_THROW(spectrum.amplitude(-6), SolverError);
  EXPECT_EQ(spectrum.amplitude(-5), 0);
}

}  // namespace
}  // namespace rubsweep::response::testing
