#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "rubsweep/core/model/length_text.hpp"
#include "rubsweep/measurement/recording/recording.hpp"

namespace rubsweep::apps {

/// Overall values of one probe. Root mean squares are those of the readings under a Hann window, which a
/// spectrum turns into the other quantity; bands end at half the sampling rate.
struct OverallValue {
  std::string column;
  /// Mean over stretches of eight turns of the distance from lowest to highest displacement.
  double peak_to_peak_m = 0;
  std::optional<double> velocity_rms_m_per_s{};       ///< casing's velocity in velocity_band_hz
  std::optional<double> acceleration_rms_m_per_s2{};  ///< accelerometer's reading in acceleration_band_hz
};

struct Band {
  double from_hz = 0, to_hz = 0;
};

/// ISO 20816-3: 10 to 1000 Hz, from 2 Hz on for machines below 600 rpm.
Band velocity_band(double speed_hz);
/// API 670, accelerometers: 10 Hz to 10 kHz.
inline constexpr Band acceleration_band{10, 10000};

/// Limits between the zones A and B, B and C, C and D.
using ZoneLimits = std::array<double, 3>;

/// Limits in m/s of the velocity rms on casings, ISO 10816-3 and ISO 20816-3.
ZoneLimits casing_limits(recording::MachineGroup group);
/// Limits in m of the displacement of a shaft relative to its casing, peak to peak, ISO 7919-3 and ISO
/// 20816-3: 4800, 9000 and 13200 um over the root of the speed in rpm; none outside 600 to 30000 rpm.
std::optional<ZoneLimits> shaft_limits(double speed_hz);

/// Zone of a value: 'A' to 'D'.
char zone_of(double value, const ZoneLimits& limits);

/// Overall values of all probes of a recording at steady speed.
std::vector<OverallValue> overall_values(const recording::Recording& recording);

/// Lines of measures.csv, and text for a terminal, with the zone of the largest value.
std::string overall_csv(const recording::Recording& recording, const std::vector<OverallValue>& values);
std::string overall_text(const recording::Recording& recording, const std::vector<OverallValue>& values,
                         const model::ShownLengths& shown);

}  // namespace rubsweep::apps
