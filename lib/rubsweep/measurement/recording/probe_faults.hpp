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

/// Readings that no motion makes.
struct WildReadings {
  std::vector<std::size_t> places{};  ///< ascending
  bool replaced = false;
};

/// Puts what their neighbours say in the place of wild readings. One is wild when it stands beyond both
/// neighbours by a quarter of the span that holds nine tenths of all readings, and one to three in a row are
/// when they are farther from the middle of that span than three times its length; in both cases they are off
/// the polynomial through three readings on either side, by fifteen times what is usual about them. Where
/// more than a fiftieth of the readings are wild, the signal is like that, and nothing is replaced. NaN are
/// passed over.
WildReadings replace_wild_readings(std::vector<double>& readings);

}  // namespace rubsweep::recording
