#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rubsweep::recording {

/// Readings of one probe in the stretch that is looked at.
struct ProbeReadings {
  std::string column;
  std::span<const double> values;
};

/// Some readings in a row.
struct Stretch {
  std::size_t first = 0, count = 0;
};

/// The longest stretch in which a probe stands still while the recording goes on: two turns or more in which
/// it moves by less than a twentieth of what it does elsewhere, and `other`, the second probe, does not.
/// Where there is no second one, it reads one value there.
std::optional<Stretch> still_stretch(std::span<const double> values, std::span<const double> other,
                                     double readings_per_turn);

/// Adds what two probes say of each other: that one shows noise alone while the other one sees a motion, and
/// that both read the same signal, but for a factor and an offset.
void add_pair_findings(const ProbeReadings& first, const ProbeReadings& second,
                       std::vector<std::string>& findings);

}  // namespace rubsweep::recording
