#include "rubsweep/measurement/diagnose/observed_lines.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "rubsweep/core/error.hpp"
#include "rubsweep/measurement/diagnose/simulated_motion.hpp"

namespace rubsweep::diagnose {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

std::vector<Complex> circle(double radius, int turns) {
  std::vector<Complex> z(static_cast<std::size_t>(turns) * samples_per_revolution);
  for (std::size_t k = 0; k < z.size(); ++k)
    z[k] = Complex(3, -1) + std::polar(radius, 2 * pi * static_cast<double>(k) / samples_per_revolution);
  return z;
}

double line(const std::vector<Complex>& z, int order) {
  Complex sum = 0;
  for (std::size_t k = 0; k < z.size(); ++k)
    sum += z[k] * std::polar(1.0, -2 * pi * order * static_cast<double>(k) / samples_per_revolution);
  return std::abs(sum) / static_cast<double>(z.size());
}

TEST(ObservedLinesOtherLines, SizeOfACircleIsItsRadiusWhereverItStands) {
  EXPECT_NEAR(size_of(circle(0.7, 3)), 0.7, 1e-12);
}

TEST(ObservedLinesOtherLines, StayBelowTheirSharesAndLeaveTheRestAlone) {
  const OtherLines lines;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    RandomStream random(seed, 0, 0);
    std::vector<Complex> z = circle(2, 3);
    add_other_lines(z, lines, 2, random);
    EXPECT_NEAR(line(z, 1), 2, 1e-12);
    EXPECT_NEAR(line(z, 4), 0, 1e-12);
    const std::vector<std::pair<int, double>> most{{-1, lines.backward_1x},
                                                   {2, lines.order_2},
                                                   {-2, lines.order_2},
                                                   {3, lines.order_3},
                                                   {-3, lines.order_3}};
    for (const auto& [order, share] : most) {
      EXPECT_GE(line(z, order), 2 * OtherLines::smallest_share * (1 - 1e-9));
      EXPECT_LE(line(z, order), 2 * share * (1 + 1e-9));
    }
  }
}

TEST(ObservedLinesOtherLines, WithoutSharesAreNone) {
  RandomStream random(1, 0, 0);
  std::vector<Complex> z = circle(2, 3);
  add_other_lines(z, {0, 0, 0}, 2, random);
  for (const int order : {-1, 2, -2, 3, -3}) EXPECT_NEAR(line(z, order), 0, 1e-12);
}

MotionLines circle() {
  MotionLines lines{20, Eigen::VectorXcd::Zero(2 * 160 + 1)};
  lines.at(20) = 1;
  return lines;
}

/// An instrument with negligible errors.
Measuring undisturbed(int probes) {
  return {.probes = probes,
          .readings_per_turn = 1e12,
          .noise_share = {1e-9, 1e-9, true},
          .other_lines = {0, 0, 0},
          .gain_error = 0,
          .free_vibration = 0};
}

TEST(ObservedLines, HaveTheNoiseOfTheReadings) {
  const Measuring measuring{.probes = 2,
                            .readings_per_turn = 50,
                            .noise_share = {0.1, 0.1, true},
                            .other_lines = {0, 0, 0},
                            .gain_error = 0,
                            .free_vibration = 0};
  double sum = 0, probe_angle_rad = 1;
  long count = 0;
  for (std::uint64_t k = 0; k < 50; ++k) {
    RandomStream random(1, k, 2);
    const MotionLines seen = observed(circle(), measuring, random, probe_angle_rad);
    for (int j = -seen.last(); j <= seen.last(); ++j)
      if (j != 20) {
        sum += std::norm(seen.at(j));
        ++count;
      }
  }
  EXPECT_EQ(probe_angle_rad, 0);
  // 1000 complex readings with noise 0.1 in x and in y: each line has the variance 2 x 0.01 / 1000.
  EXPECT_NEAR(sum / static_cast<double>(count), 2e-5, 0.02 * 2e-5);
}

TEST(ObservedLines, OfOneProbeAreThoseOfARealSignal) {
  const Measuring measuring{.probes = 1, .readings_per_turn = 50};
  RandomStream random(3, 1, 2);
  double probe_angle_rad = 0;
  const MotionLines seen = observed(circle(), measuring, random, probe_angle_rad);
  EXPECT_NE(probe_angle_rad, 0);
  for (int k = 0; k <= seen.last(); ++k) EXPECT_LT(std::abs(seen.at(-k) - std::conj(seen.at(k))), 1e-15);
  EXPECT_NEAR(std::abs(seen.at(20)), 0.5, 0.2);
}

TEST(ObservedLines, OfOneProbeWhoseDirectionIsKnownAreThoseInIt) {
  Measuring measuring = undisturbed(1);
  measuring.directions = true;
  measuring.probe_angle_rad = 0.7;
  RandomStream random(3, 1, 2);
  double probe_angle_rad = 0;
  const MotionLines seen = observed(circle(), measuring, random, probe_angle_rad);
  EXPECT_EQ(probe_angle_rad, 0.7);
  EXPECT_LT(std::abs(seen.at(20) - std::polar(0.5, -0.7)), 1e-6);
}

TEST(ObservedLines, HaveASmallFreeVibrationAtTheNaturalFrequencyInHalfOfTheCases) {
  Measuring measuring = undisturbed(2);
  measuring.free_vibration = 0.01;
  measuring.natural_order = 7.3 / 20;
  int natural = 0, visible = 0;
  double probe_angle_rad = 0;
  for (std::uint64_t k = 0; k < 400; ++k) {
    RandomStream random(6, k, 2);
    MotionLines seen = observed(circle(), measuring, random, probe_angle_rad);
    seen.at(20) = 0;
    int strongest = 0;
    for (int j = -seen.last(); j <= seen.last(); ++j)
      if (std::abs(seen.at(j)) > std::abs(seen.at(strongest))) strongest = j;
    EXPECT_LT(size_of(seen), 0.01 * (1 + 1e-6));
    visible += size_of(seen) > 1e-3 ? 1 : 0;
    natural += std::abs(strongest) == 7 || std::abs(strongest) == 8 ? 1 : 0;
  }
  // A third of the amplitudes is above a tenth of the largest; decay makes some of them smaller.
  EXPECT_NEAR(visible, 100, 40);
  EXPECT_NEAR(natural, 200, 33);
}

TEST(ObservedLines, DecayAsAFreeVibrationDoes) {
  // Over thirds of the recorded turns, the energy of an exponential has a geometric mean in the middle.
  Measuring measuring = undisturbed(2);
  measuring.free_vibration = 0.01;
  measuring.natural_order = 7.3 / 20;
  response::spectrum::SpectrumWorkspace workspace;
  double probe_angle_rad = 0, mean = 0;
  int checked = 0;
  for (std::uint64_t k = 0; k < 400; ++k) {
    RandomStream random(7, k, 2);
    MotionLines seen = observed(circle(), measuring, random, probe_angle_rad);
    seen.at(20) -= 1;
    const Eigen::VectorXcd z = waveform_of(seen, 32, workspace);
    const auto energy = [&](int from) { return z.segment(from, 192).squaredNorm(); };
    if (std::abs(seen.at(7)) + std::abs(seen.at(-7)) < 0.4 * size_of(seen) || size_of(seen) < 1e-4) continue;
    const double early = energy(32), middle = energy(224), late = energy(416);
    EXPECT_LT(late, 1.1 * early) << k;
    mean += std::log(middle * middle / (early * late));
    ++checked;
  }
  EXPECT_GT(checked, 60);
  EXPECT_NEAR(mean / checked, 0, 0.05);
}

TEST(ObservedLines, CountFromAPlaceOfRestThatIsKnownNearly) {
  Measuring measuring{.readings_per_turn = 50, .from_rest = true, .free_vibration = 0};
  double square = 0, probe_angle_rad = 0;
  constexpr int draws = 400;
  for (std::uint64_t k = 0; k < draws; ++k) {
    RandomStream random(4, k, 2);
    square += std::norm(observed(circle(), measuring, random, probe_angle_rad).at(0)) / draws;
  }
  // The mean contains the rest error in x and in y, and a little noise.
  EXPECT_NEAR(square, 2 * Measuring::rest_error * Measuring::rest_error, 1e-4);
}

TEST(ObservedLines, OfUnequalGainsAreAnEllipse) {
  Measuring measuring = undisturbed(2);
  measuring.gain_error = 0.1;
  RandomStream random(5, 1, 2);
  double probe_angle_rad = 0;
  const MotionLines seen = observed(circle(), measuring, random, probe_angle_rad);
  // Gains gx and gy give (gx + gy) / 2 forward and (gx - gy) / 2 backward.
  const double gx = (seen.at(20) + seen.at(-20)).real(), gy = (seen.at(20) - seen.at(-20)).real();
  EXPECT_NE(gx, gy);
  EXPECT_NEAR(gx, 1, 0.5);
  EXPECT_NEAR(gy, 1, 0.5);
}

/// Samples of a motion with a mean and lines at 1/2, -1 and 2, over 6 turns.
std::vector<Complex> samples() {
  std::vector<Complex> z;
  for (int j = 0; j < 6 * 32; ++j) {
    const double angle = 2 * std::numbers::pi * j / 32;
    z.push_back(Complex(5, 1) + std::polar(2.0, angle / 2 + 0.3) + std::polar(1.0, -angle) +
                std::polar(0.5, 2 * angle));
  }
  return z;
}

TEST(ObservedLinesMotionLines, AreTheAmplitudesOfTheMotion) {
  response::spectrum::SpectrumWorkspace workspace;
  const MotionLines lines = lines_of(samples(), 6, 3, workspace);
  EXPECT_EQ(lines.last(), 18);
  EXPECT_LT(std::abs(lines.at(3) - std::polar(2.0, 0.3)), 1e-13);
  EXPECT_LT(std::abs(lines.at(-6) - 1.0), 1e-13);
  EXPECT_LT(std::abs(lines.at(12) - 0.5), 1e-13);
  EXPECT_LT(std::abs(lines.at(5)), 1e-13);
  EXPECT_NEAR(size_of(lines), std::sqrt(4 + 1 + 0.25), 1e-13);
}

TEST(ObservedLinesMotionLines, GiveTheMotionBackWithoutItsMean) {
  response::spectrum::SpectrumWorkspace workspace;
  const std::vector<Complex> z = samples();
  const Eigen::VectorXcd waveform = waveform_of(lines_of(z, 6, 3, workspace), 32, workspace);
  for (Eigen::Index j = 0; j < waveform.size(); ++j)
    EXPECT_LT(std::abs(waveform(j) + Complex(5, 1) - z[static_cast<std::size_t>(j)]), 1e-12) << j;
}

TEST(ObservedLinesMotionLines, CanBeCutOffAtAnOrder) {
  response::spectrum::SpectrumWorkspace workspace;
  const MotionLines all = lines_of(samples(), 6, 3, workspace), some = up_to(all, 1.5);
  EXPECT_EQ(some.last(), 9);
  EXPECT_EQ(some.at(-6), all.at(-6));
  EXPECT_EQ(up_to(all, 10).last(), all.last());
}

TEST(ObservedLinesMotionLines, NeedSamplesEnough) {
  response::spectrum::SpectrumWorkspace workspace;
  EXPECT_THROW(lines_of(samples(), 6, 16, workspace), SolverError);
}

}  // namespace
}  // namespace rubsweep::diagnose
