#include "rubsweep/measurement/diagnose/motion_lines.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "rubsweep/core/error.hpp"

namespace rubsweep::diagnose {
namespace {

using Complex = std::complex<double>;

/// Lines at 1/2, -1 and 2, and a mean, over 6 turns.
std::vector<Complex> samples() {
  std::vector<Complex> z;
  for (int j = 0; j < 6 * 32; ++j) {
    const double angle = 2 * std::numbers::pi * j / 32;
    z.push_back(Complex(5, 1) + std::polar(2.0, angle / 2 + 0.3) + std::polar(1.0, -angle) +
                std::polar(0.5, 2 * angle));
  }
  return z;
}

TEST(MotionLines, AreTheAmplitudesOfTheMotion) {
  response::spectrum::SpectrumWorkspace workspace;
  const MotionLines lines = lines_of(samples(), 6, 3, workspace);
  EXPECT_EQ(lines.last(), 18);
  EXPECT_LT(std::abs(lines.at(3) - std::polar(2.0, 0.3)), 1e-13);
  EXPECT_LT(std::abs(lines.at(-6) - 1.0), 1e-13);
  EXPECT_LT(std::abs(lines.at(12) - 0.5), 1e-13);
  EXPECT_LT(std::abs(lines.at(5)), 1e-13);
  EXPECT_NEAR(size_of(lines), std::sqrt(4 + 1 + 0.25), 1e-13);
}

TEST(MotionLines, GiveTheMotionBackWithoutItsMean) {
  response::spectrum::SpectrumWorkspace workspace;
  const std::vector<Complex> z = samples();
  const Eigen::VectorXcd waveform = waveform_of(lines_of(z, 6, 3, workspace), 32, workspace);
  for (Eigen::Index j = 0; j < waveform.size(); ++j)
    EXPECT_LT(std::abs(waveform(j) + Complex(5, 1) - z[static_cast<std::size_t>(j)]), 1e-12) << j;
}

TEST(MotionLines, CanBeCutOffAtAnOrder) {
  response::spectrum::SpectrumWorkspace workspace;
  const MotionLines all = lines_of(samples(), 6, 3, workspace), some = up_to(all, 1.5);
  EXPECT_EQ(some.last(), 9);
  EXPECT_EQ(some.at(-6), all.at(-6));
  EXPECT_EQ(up_to(all, 10).last(), all.last());
}

TEST(MotionLines, NeedSamplesEnough) {
  response::spectrum::SpectrumWorkspace workspace;
  EXPECT_THROW(lines_of(samples(), 6, 16, workspace), SolverError);
}

}  // namespace
}  // namespace rubsweep::diagnose
