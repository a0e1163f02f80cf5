#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "rubsweep/core/error.hpp"

namespace rubsweep::batch {

/// Number of steps of size `step` > 0 from `from` to `to`, in either direction. Counts in decimals: from 30
/// to 31 there are ten steps of 0.1, although the doubles of these numbers do not fit exactly. Empty where no
/// whole number of steps ends at `to`, or where the three numbers together need more than 15 digits.
std::optional<std::int64_t> whole_steps(double from, double to, double step);

/// The two neighbouring values of the sequence `from`, `from` +- `step`, ... between which `to` lies; the
/// value nearer to `from` comes first. Used to advise a user whose steps miss `to`. Empty where the three
/// numbers together need more than 15 digits.
std::optional<std::pair<double, double>> steps_beside(double from, double to, double step);

/// Values from `from` to `to`, both included, at distances of `step`. Each is the double nearest to its
/// decimal: 30.3 and not 30.299999999999997. Throws std::invalid_argument where whole_steps is empty.
std::vector<double> decimal_steps(double from, double to, double step);

/// `count` evenly spaced values from `from` to `to`; either may be larger. The first is exactly `from`, the
/// last exactly `to`, and none lies outside. A count of 1 gives `from` alone. Throws ConfigError where count
/// < 1.
inline std::vector<double> evenly_spaced(double from, double to, int count) {
  if (count < 1) {
    throw ConfigError(std::string("count: ")
                          .append(std::to_string(count))
                          .append(" is out of range, allowed: a number >= 1"));
  }
  std::vector<double> values(static_cast<std::size_t>(count), from);
  const auto [low, high] = std::minmax(from, to);
  const double intervals = count - 1;
  for (int i = 1; i + 1 < count; ++i) {
    // Multiplication before division: integers stay exact where the grid allows it.
    const double value = from + (to - from) * i / intervals;
    values[static_cast<std::size_t>(i)] = std::clamp(value, low, high);
  }
  if (count > 1) values.back() = to;
  return values;
}

/// `count` values from `from` to `to`, both > 0, with equal ratios of neighbours.
inline std::vector<double> logarithmically_spaced(double from, double to, int count) {
  std::vector<double> values = evenly_spaced(std::log(from), std::log(to), count);
  const auto [low, high] = std::minmax(from, to);
  for (double& value : values) value = std::clamp(std::exp(value), low, high);
  values.front() = from;
  if (count > 1) values.back() = to;
  return values;
}

/// Definition of an axis by its ends, in the unit in which it was written.
struct Spacing {
  double from = 0, to = 0;
  int count = 1;
  bool logarithmic = false;
  double step = 0;  ///< distance of the values, see decimal_steps; 0: spaced by the count

  bool operator==(const Spacing&) const = default;
};

/// Values of an axis in SI units; 1 SI unit is `units_per_si` written units. With a count, the ends are
/// converted first, and the values between them are spaced in SI units. With a step, each value is converted.
/// Throws ConfigError as evenly_spaced does, and std::invalid_argument as decimal_steps does.
inline std::vector<double> spaced(const Spacing& spacing, double units_per_si = 1) {
  if (spacing.step > 0) {
    std::vector<double> values = decimal_steps(spacing.from, spacing.to, spacing.step);
    for (double& value : values) value /= units_per_si;
    return values;
  }
  const double first = spacing.from / units_per_si, last = spacing.to / units_per_si;
  return spacing.logarithmic ? logarithmically_spaced(first, last, spacing.count)
                             : evenly_spaced(first, last, spacing.count);
}

}  // namespace rubsweep::batch
