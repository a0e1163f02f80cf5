#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <random>

#include "rubsweep/recording/recording.hpp"
#include "rubsweep/scope/verdict.hpp"

/// From the columns of a table to the verdict.
namespace rubsweep::scope {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

/// A 1/2 motion at about 70 rev/s and 5 kHz with a keyway whose edges last `edge` samples.
recording::Channels half_order(double speed_hz, double edge, double noise_um) {
  std::mt19937_64 random(5);
  std::normal_distribution<double> noise(0, noise_um);
  recording::Channels table;
  table.channels = {{"X", "um", {}}, {"Y", "um", {}}, {"KP", "V", {}}};
  for (int k = 0; k < 10000; ++k) {
    const double turns = speed_hz * k / 5000 + 0.4;
    const Complex z = 80.0 * std::polar(1.0, 2 * pi * turns) + Complex(50, 20) * std::polar(1.0, pi * turns) +
                      30.0 * std::polar(1.0, -pi * turns);
    const double since = (turns - std::floor(turns)) / speed_hz * 5000;
    table.channels[0].values.push_back(z.real() + noise(random));
    table.channels[1].values.push_back(z.imag() + noise(random));
    table.channels[2].values.push_back(since < 6 ? -2 - 10 * std::fmin(1, since / edge) : -2);
  }
  return table;
}

const recording::Instrument instrument{.sampling_rate_hz = 5000,
                                       .probes = {{"X", 0}, {"Y", 90}},
                                       .keyphasor = recording::Keyphasor{.column = "KP"}};

TEST(RecordedMotion, EdgesBetweenTwoSamplesDoNotSmearItsLines) {
  // Speeds whose turns are whole numbers of samples, nearly so, and anything.
  for (const double speed_hz : {5000.0 / 71, 5000.0 / 71.02, 5000.0 / 71.37, 70.0}) {
    for (const double edge : {0.01, 1.4, 3.0}) {
      const auto read = recording::make_recording(half_order(speed_hz, edge, 0.5), instrument, "f");
      const Verdict verdict = judge(read.displacement_m, recording::samples_per_revolution, true);
      EXPECT_EQ(verdict.motion, MeasuredClass::subharmonic) << speed_hz << ' ' << edge;
      EXPECT_EQ(verdict.period, 2) << speed_hz << ' ' << edge;
    }
  }
}

}  // namespace
}  // namespace rubsweep::scope
