#include "rubsweep/core/response/spectrum/resolved_lines.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace rubsweep::response::spectrum {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

struct Put {
  double frequency;
  Complex amplitude;
};

std::vector<Complex> sum_of(const std::vector<Put>& lines, std::size_t count, double noise, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal(0, noise);
  std::vector<Complex> samples(count);
  for (std::size_t k = 0; k < count; ++k) {
    for (const Put& line : lines)
      samples[k] += line.amplitude * std::polar(1.0, 2 * pi * line.frequency * static_cast<double>(k));
    if (noise > 0) samples[k] += Complex(normal(random), normal(random));
  }
  return samples;
}

const std::vector<Put> whirl{
    {0, {500, -300}}, {1.0 / 32, {60, 80}}, {0.15 / 32, {0, 80}}, {-0.41 / 32, {7, 0}}};

TEST(ResolvedLines, LinesBetweenBinsAreThoseThatWerePutIn) {
  SpectrumWorkspace workspace;
  const auto found = resolve_lines(sum_of(whirl, 61 * 32, 0, 1), {.least_amplitude = 1}, workspace);
  ASSERT_EQ(found.size(), 3u);
  for (std::size_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(found[k].frequency, whirl[k + 1].frequency, 1e-6) << k;
    EXPECT_LT(std::abs(found[k].amplitude - whirl[k + 1].amplitude), 0.02) << k;
  }
}

TEST(ResolvedLines, SpreadAsTheirUncertaintiesSay) {
  SpectrumWorkspace workspace;
  double frequencies = 0, amplitudes = 0, count = 0;
  for (unsigned seed = 1; seed <= 60; ++seed) {
    const auto found = resolve_lines(sum_of(whirl, 40 * 32, 5, seed), {.least_amplitude = 3}, workspace);
    ASSERT_GE(found.size(), 3u);
    for (std::size_t k = 0; k < 3; ++k) {
      frequencies +=
          std::pow((found[k].frequency - whirl[k + 1].frequency) / found[k].frequency_uncertainty, 2);
      amplitudes += std::pow(
          (std::abs(found[k].amplitude) - std::abs(whirl[k + 1].amplitude)) / found[k].amplitude_uncertainty,
          2);
      ++count;
    }
  }
  EXPECT_NEAR(frequencies / count, 0.85, 0.4);
  EXPECT_NEAR(amplitudes / count, 0.85, 0.4);
}

TEST(ResolvedLines, ALineThatChangesSaysSo) {
  SpectrumWorkspace workspace;
  auto samples = sum_of({{0.0301, {1, 0}}}, 2048, 1e-4, 1);
  for (std::size_t k = 0; k < samples.size(); ++k) samples[k] *= 1 + 0.2 * static_cast<double>(k) / 2048;
  const auto found = resolve_lines(samples, {.least_amplitude = 0.1}, workspace);
  ASSERT_EQ(found.size(), 1u);
  // The amplitudes of the two halves are 1.05 and 1.15.
  EXPECT_NEAR(found[0].amplitude_uncertainty, 0.05, 0.01);
}

TEST(ResolvedLines, OnlyTheFrequenciesThatAreAskedForAreLookedAt) {
  SpectrumWorkspace workspace;
  const auto found = resolve_lines(sum_of(whirl, 1024, 0, 1),
                                   {.least_amplitude = 1, .lowest = -0.02, .highest = 0.02}, workspace);
  ASSERT_FALSE(found.empty());
  for (const ResolvedLine& line : found) EXPECT_LT(std::abs(line.frequency), 0.0205);
}

}  // namespace
}  // namespace rubsweep::response::spectrum
