#include "rubsweep/core/response/spectrum/discrete_lines.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

#include "core/response/synthetic_motion.hpp"
#include "rubsweep/core/error.hpp"

namespace rubsweep::response::spectrum {
namespace {

using std::numbers::pi;
using testing::Complex;
using testing::phasor;

/// Samples of 0X plus a line of `order` whose amplitude is a function of the turn; 64 samples per turn.
template <typename Amplitude>
std::vector<std::complex<double>> samples_of(int turns, double order, const Amplitude& amplitude) {
  std::vector<std::complex<double>> samples;
  for (int k = 0; k < 64 * turns; ++k)
    samples.push_back(1e-3 + std::polar(amplitude(k / 64.0), 2 * pi * order * k / 64));
  return samples;
}

TEST(DiscreteLinesHannWindow, ASteadyLineKeepsItsAmplitudeAndHasHalfOfItBeside) {
  SpectrumWorkspace workspace;
  const FullSpectrum spectrum =
      windowed_spectrum(samples_of(20, -0.5, [](double) { return 2e-5; }), 20, workspace);
  EXPECT_NEAR(spectrum.amplitude(0), 1e-3, 1e-12);
  for (int k = -100; k <= 100; ++k) {
    if (k == 0) continue;
    const double expected = k == -10 ? 2e-5 : k == -9 || k == -11 ? 1e-5 : 0;
    EXPECT_NEAR(spectrum.amplitude(k), expected, 1e-12) << k;
  }
}

TEST(DiscreteLinesHannWindow, ALineThatSwellsHasNoSkirt) {
  const auto samples = samples_of(20, 1.013, [](double turn) { return 1e-4 * std::exp(turn / 4 - 5); });
  SpectrumWorkspace workspace;
  const FullSpectrum plain = full_spectrum(samples, 20, workspace);
  const FullSpectrum windowed = windowed_spectrum(samples, 20, workspace);
  // Leakage at 4X, 60 lines away.
  EXPECT_GT(plain.amplitude(80), 5e-4 * plain.amplitude(20));
  EXPECT_LT(windowed.amplitude(80), 1e-5 * windowed.amplitude(20));
}

struct Pure {
  double order = 0;
  double amplitude = 1;
};

/// Once-per-turn samples from turn `first` on.
std::vector<Complex> strobe(const std::vector<Pure>& lines, int first, int count) {
  std::vector<Complex> z;
  for (int k = first; k < first + count; ++k) {
    Complex sum = 0;
    for (const Pure& line : lines) sum += line.amplitude * phasor(line.order, k);
    z.push_back(sum);
  }
  return z;
}

std::vector<double> shares(const std::vector<Complex>& z) {
  spectrum::SpectrumWorkspace workspace;
  return spectrum::energy_shares(z, workspace);
}

bool same(const std::vector<Complex>& first, const std::vector<Complex>& second) {
  spectrum::SpectrumWorkspace workspace;
  return spectrum::same_discrete_lines(first, second, workspace);
}

std::vector<Complex> noise(int count, unsigned seed) {
  std::mt19937 bits(seed);
  std::normal_distribution<double> normal;
  std::vector<Complex> z;
  for (int k = 0; k < count; ++k) z.emplace_back(normal(bits), normal(bits));
  return z;
}

const std::vector<Pure> torus{{0.3819660113, 1}, {0.7639320225, 0.3}, {0.1458980338, 0.2}};

TEST(DiscreteLinesEnergyShares, OfALineStandInFiveBinsWhereverItFalls) {
  for (const double bins : {40.0, 40.25, 40.5}) {
    const auto found = shares(strobe({{bins / 256, 3}}, 0, 256));
    EXPECT_NEAR(std::accumulate(found.begin(), found.end(), 0.0), 1, 1e-12);
    EXPECT_EQ(spectrum::lines_holding(found, 0.995), 1) << bins;
  }
}

TEST(DiscreteLinesEnergyShares, LeaveTheMeanOut) {
  auto z = strobe(torus, 0, 256);
  const auto without = shares(z);
  for (Complex& value : z) value += Complex(100, -50);
  const auto with = shares(z);
  for (std::size_t k = 0; k < with.size(); ++k) EXPECT_NEAR(with[k], without[k], 1e-11);
  const auto constant = shares(std::vector<Complex>(64, Complex(2, 3)));
  EXPECT_EQ(std::accumulate(constant.begin(), constant.end(), 0.0), 0);
  EXPECT_EQ(spectrum::lines_holding(constant, 0.99), 0);
}

TEST(DiscreteLinesHolding, CountsLinesByTheirEnergy) {
  // Energies 1, 0.09 and 0.04 of 1.13 in total: cumulative shares 88.5 %, 96.5 %, 100 %.
  const auto found = shares(strobe(torus, 0, 256));
  EXPECT_EQ(spectrum::lines_holding(found, 0.88), 1);
  EXPECT_EQ(spectrum::lines_holding(found, 0.9), 2);
  EXPECT_EQ(spectrum::lines_holding(found, 0.99), 3);
  EXPECT_GT(spectrum::lines_holding(shares(noise(256, 2)), 0.99), 30);
}

TEST(DiscreteLinesMovedShare, IsTheEnergyThatStandsElsewhere) {
  // The second line moves from order 0.3 to 0.7, which is 20 % of the energy.
  const auto before = shares(strobe({{0.1, 2}, {0.3, 1}}, 0, 250));
  const auto after = shares(strobe({{0.1, 2}, {0.7, 1}}, 0, 250));
  EXPECT_NEAR(spectrum::moved_share(before, after), 0.2, 1e-3);
  EXPECT_NEAR(spectrum::moved_share(after, before), 0.2, 1e-3);
  EXPECT_EQ(spectrum::moved_share(before, before), 0);
  // A change of the energy ratio from 1 : 1 to 3 : 1 moves a quarter.
  EXPECT_NEAR(spectrum::moved_share(shares(strobe({{0.1, 1}, {0.3, 1}}, 0, 250)),
                                    shares(strobe({{0.1, std::sqrt(3)}, {0.3, 1}}, 0, 250))),
              0.25, 1e-3);
  EXPECT_THROW(spectrum::moved_share(before, std::vector<double>(100)), SolverError);
}

TEST(DiscreteLinesSame, OnATorusWhateverItsPhase) {
  EXPECT_TRUE(same(strobe(torus, 0, 256), strobe(torus, 256, 256)));
  EXPECT_TRUE(same(strobe(torus, 0, 256), strobe(torus, 12345, 256)));
}

TEST(DiscreteLinesSame, NotWhenALineMovesOrChanges) {
  auto moved = torus, louder = torus;
  moved[1].order += 0.02;
  louder[1].amplitude *= 1.2;
  EXPECT_FALSE(same(strobe(torus, 0, 256), strobe(moved, 256, 256)));
  EXPECT_FALSE(same(strobe(torus, 0, 256), strobe(louder, 256, 256)));
  louder[1].amplitude = torus[1].amplitude * 1.02;
  EXPECT_TRUE(same(strobe(torus, 0, 256), strobe(louder, 256, 256)));
}

TEST(DiscreteLinesSame, NotInNoiseNorInChaos) {
  EXPECT_FALSE(same(noise(256, 1), noise(256, 2)));
  std::vector<Complex> henon;
  double x = 0.1, y = 0.2;
  for (int k = 0; k < 512; ++k) {
    const double next = 1 - 1.4 * x * x + y;
    y = 0.3 * x;
    x = next;
    henon.emplace_back(x * phasor(0.381, k));
  }
  EXPECT_FALSE(same({henon.begin(), henon.begin() + 256}, {henon.begin() + 256, henon.end()}));
}

TEST(DiscreteLinesSame, NotWhenThereAreManyEvenIfTheyStay) {
  std::vector<Pure> many;
  for (int i = 0; i < 20; ++i) many.push_back({0.045 * i + 0.01, 1});
  EXPECT_FALSE(same(strobe(many, 0, 512), strobe(many, 512, 512)));
  many.resize(16);
  EXPECT_TRUE(same(strobe(many, 0, 512), strobe(many, 512, 512)));
}

}  // namespace

}  // namespace rubsweep::response::spectrum
