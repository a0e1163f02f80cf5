#include "rubsweep/core/response/spectrum/hann_window.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

namespace rubsweep::response::spectrum {
namespace {

using std::numbers::pi;

/// 0X, and a line of `order` whose amplitude is given turn by turn; 64 samples a turn.
template <typename Amplitude>
std::vector<std::complex<double>> samples_of(int turns, double order, const Amplitude& amplitude) {
  std::vector<std::complex<double>> samples;
  for (int k = 0; k < 64 * turns; ++k)
    samples.push_back(1e-3 + std::polar(amplitude(k / 64.0), 2 * pi * order * k / 64));
  return samples;
}

TEST(HannWindow, ASteadyLineKeepsItsAmplitudeAndHasHalfOfItBeside) {
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

TEST(HannWindow, ALineThatSwellsHasNoSkirt) {
  const auto samples = samples_of(20, 1.013, [](double turn) { return 1e-4 * std::exp(turn / 4 - 5); });
  SpectrumWorkspace workspace;
  const FullSpectrum plain = full_spectrum(samples, 20, workspace);
  const FullSpectrum windowed = windowed_spectrum(samples, 20, workspace);
  // At 4X, 60 lines away.
  EXPECT_GT(plain.amplitude(80), 5e-4 * plain.amplitude(20));
  EXPECT_LT(windowed.amplitude(80), 1e-5 * windowed.amplitude(20));
}

}  // namespace
}  // namespace rubsweep::response::spectrum
