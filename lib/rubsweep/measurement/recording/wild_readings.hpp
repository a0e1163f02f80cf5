#pragma once

#include <cstddef>
#include <vector>

namespace rubsweep::recording {

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
