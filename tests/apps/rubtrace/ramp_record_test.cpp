#include "rubtrace/ramp_record.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace rubsweep::ramp {
namespace {

using std::numbers::pi;

/// An artificial exact motion: forward 1X with 1 mm, backward 1/3X with 0.2 mm.
RampSample sample_at(const SpeedRamp& ramp, double t_s) {
  const double angle = ramp.angle_rad(t_s), w = 2 * pi * ramp.speed_hz(t_s);
  const auto z = 1e-3 * std::polar(1.0, angle) + 2e-4 * std::polar(1.0, -angle / 3);
  const std::complex<double> i(0, 1);
  const auto v = w * (1e-3 * i * std::polar(1.0, angle) - 2e-4 / 3 * i * std::polar(1.0, -angle / 3));
  return {t_s, {z.real(), z.imag()}, {v.real(), v.imag()}};
}

/// Adds samples with contact between 12 and 14 s, and once at 20 s.
void add_all(const SpeedRamp& ramp, RampRecord& record) {
  const double period_s = 1 / ramp.fastest_hz();
  const long stretches = std::lround(ramp.duration_s() / period_s);
  for (long n = 0; n < stretches; ++n) {
    RampStretch stretch;
    stretch.begin_s = static_cast<double>(n) * period_s;
    stretch.end_s = stretch.begin_s + period_s;
    for (int k = 0; k < 64; ++k)
      stretch.samples.push_back(sample_at(ramp, stretch.begin_s + k * period_s / 64));
    const double t_s = stretch.begin_s;
    stretch.touched = (t_s >= 12 && t_s < 14 && n % 6 == 0) || std::abs(t_s - 20) < period_s / 2;
    stretch.hits = stretch.touched;
    stretch.peak_displacement_m = 1.2e-3;
    record.add(stretch);
  }
}

TEST(RampRecord, OrdersStayOneLineWhateverTheSpeedDoes) {
  for (const SpeedRamp& ramp : {SpeedRamp{20, 60, 1.6, 0}, SpeedRamp{60, 20, -1.6, 0}}) {
    RampRecord record(ramp);
    add_all(ramp, record);
    ASSERT_GE(record.spectra().size(), 15u);
    for (const OrderSpectrum& at : record.spectra()) {
      EXPECT_NEAR(at.spectrum.amplitude(spectrum_turns), 1e-3, 1e-9);
      EXPECT_NEAR(at.spectrum.amplitude(-spectrum_turns / 3), 2e-4, 1e-9);
      EXPECT_NEAR(at.spectrum.amplitude(spectrum_turns / 2), 0, 1e-9);
      EXPECT_NEAR(at.speed_hz, ramp.speed_hz(at.t_s), 1e-9);
    }
  }
}

TEST(RampRecord, EnvelopeHoldsTheExtremes) {
  const SpeedRamp ramp{20, 60, 1.6, 0};
  RampRecord record(ramp);
  add_all(ramp, record);
  EXPECT_EQ(record.envelope().size(), most_envelope_points);
  int hits = 0;
  double duration_s = 0;
  for (const EnvelopePoint& point : record.envelope()) {
    EXPECT_GT(point.highest_x_m, 0.5e-3);
    EXPECT_LE(point.highest_x_m, 1.2e-3 + 1e-12);
    EXPECT_GE(point.lowest_y_m, -1.2e-3 - 1e-12);
    EXPECT_LT(point.lowest_y_m, -0.5e-3);
    hits += point.hits;
    duration_s += point.duration_s;
  }
  EXPECT_EQ(hits, 21);
  EXPECT_NEAR(duration_s, ramp.duration_s(), 1e-9);
}

TEST(RampRecord, SpansGoOnOverShortGapsOnly) {
  const SpeedRamp ramp{20, 60, 1.6, 0};
  RampRecord record(ramp);
  add_all(ramp, record);
  const auto spans = record.rubbing_spans();
  ASSERT_EQ(spans.size(), 2u);
  EXPECT_NEAR(spans[0].from_hz, ramp.speed_hz(12), 0.2);
  EXPECT_NEAR(spans[0].to_hz, ramp.speed_hz(14), 0.2);
  EXPECT_NEAR(spans[1].from_hz, ramp.speed_hz(20), 0.05);
}

TEST(RampRecord, OrbitsOfAFewTurnsAreSpreadOverTheRamp) {
  const SpeedRamp ramp{20, 60, 1.6, 0};
  RampRecord record(ramp);
  add_all(ramp, record);
  ASSERT_EQ(record.orbits().size(), static_cast<std::size_t>(orbits_of_a_ramp));
  for (std::size_t i = 0; i < record.orbits().size(); ++i) {
    const RampOrbit& orbit = record.orbits()[i];
    EXPECT_NEAR(orbit.speed_hz, 20 + 40 * (static_cast<double>(i) + 0.5) / orbits_of_a_ramp, 0.05);
    const double turns =
        (ramp.angle_rad(orbit.samples.back().t_s) - ramp.angle_rad(orbit.samples.front().t_s)) / (2 * pi);
    EXPECT_NEAR(turns, turns_of_an_orbit, 0.05);
  }
}

}  // namespace
}  // namespace rubsweep::ramp
