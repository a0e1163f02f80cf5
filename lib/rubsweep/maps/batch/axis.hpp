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

/// Number of steps of the size `step` that lead from `from` to `to`, in either direction, counted in
/// decimals: from 30 to 31 there are ten of 0.1, although the doubles of these numbers say otherwise. `step`
/// > 0. Empty where no whole number of them meets `to`, and where the three numbers span more than 15 digits.
std::optional<std::int64_t> whole_steps(double from, double to, double step);

/// Values of these steps from `from` on between which `to` lies, the nearer one to `from` first: for somebody
/// whose steps miss it. Empty where the three numbers span more than 15 digits.
std::optional<std::pair<double, double>> steps_beside(double from, double to, double step);

/// Values from `from` to `to`, both included, by these steps: each the double nearest to its decimal, 30.3
/// and not 30.299999999999997. Throws std::invalid_argument where whole_steps is empty.
std::vector<double> decimal_steps(double from, double to, double step);

/// `count` values from `from` to `to` (either may be the larger one) at equal distances. The first is exactly
/// `from`, the last exactly `to`, none lies outside; a count of 1 gives `from` alone.
/// Throws ConfigError when count < 1.
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
    // Multiplied before divided: whole numbers stay whole where the grid allows it.
    const double value = from + (to - from) * i / intervals;
    values[static_cast<std::size_t>(i)] = std::clamp(value, low, high);
  }
  if (count > 1) values.back() = to;
  return values;
}

/// The same at equal ratios: `from` and `to` > 0.
inline std::vector<double> logarithmically_spaced(double from, double to, int count) {
  std::vector<double> values = evenly_spaced(std::log(from), std::log(to), count);
  const auto [low, high] = std::minmax(from, to);
  for (double& value : values) value = std::clamp(std::exp(value), low, high);
  values.front() = from;
  if (count > 1) values.back() = to;
  return values;
}

/// Form in which an axis gives its values, in the unit that it is written in.
struct Spacing {
  double from = 0, to = 0;
  int count = 1;
  bool logarithmic = false;
  double step = 0;  ///< 0: by the count; else the values stand so far apart, see decimal_steps

  bool operator==(const Spacing&) const = default;
};

/// Values in SI units, of which one is `units_per_si` of the written ones: the ends are divided before the
/// values between them are placed. By a step, each value is divided. Throws ConfigError as evenly_spaced, and
/// std::invalid_argument as decimal_steps.
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
