#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rubsweep::recording {

/// Readings of one probe in the evaluated interval.
struct ProbeReadings {
  std::string column;
  std::span<const double> values;
};

/// Consecutive readings: the index of the first one, and their number.
struct Stretch {
  std::size_t first = 0, count = 0;
};

/// The longest stretch in which a probe is stuck while the recording goes on. For two turns or more the stuck
/// probe moves by less than a twentieth of its usual range, whereas `other`, the second probe, moves. Without
/// a second probe the stuck probe must read a constant value there.
std::optional<Stretch> still_stretch(std::span<const double> values, std::span<const double> other,
                                     double readings_per_turn);

/// Adds faults found by comparing two probes: one shows only noise while the other shows a motion, or both
/// read the same signal, up to a factor and an offset.
void add_pair_findings(const ProbeReadings& first, const ProbeReadings& second,
                       std::vector<std::string>& findings);

/// Outliers, which no motion can cause.
struct WildReadings {
  std::vector<std::size_t> places{};  ///< ascending
  bool replaced = false;
};

/// Replaces outliers by values interpolated from their neighbours. The usual interval contains nine tenths of
/// all readings. A single reading is suspected if it exceeds both neighbours by a quarter of this interval. A
/// group of one to three readings is suspected if its distance from the interval's centre exceeds three
/// interval lengths. Suspected readings are outliers if their distance from the polynomial through three
/// readings on either side is fifteen times the usual one nearby. If more than 2 % of the readings are
/// outliers, the signal is not changed. NaN are skipped.
WildReadings replace_wild_readings(std::vector<double>& readings);

}  // namespace rubsweep::recording
