#pragma once

#include <limits>
#include <string>

namespace rubsweep::model {

/// Interval of allowed values of one number.
struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_open = false;   ///< true: `low` itself is not allowed
  bool high_open = false;  ///< true: `high` itself is not allowed
};

inline constexpr Range any_finite{};
inline constexpr Range positive{.low = 0, .low_open = true};
inline constexpr Range not_negative{.low = 0};

/// True when `value` is finite and inside the interval.
bool contains(const Range& range, double value);

/// Allowed values, in words that finish "allowed: ", e.g. "a number > 0" or "a number >= 0 and <= 1".
std::string describe(const Range& range);

/// Marks a number that has no default and must be given. A signalling NaN, so that using it is loud.
inline constexpr double required = std::numeric_limits<double>::signaling_NaN();

/// No number of a machine is larger, or smaller without being 0: far wider than anything that was ever built,
/// yet so narrow that products of several numbers stay finite and keep their digits. `contains` goes by it.
inline constexpr double smallest_magnitude = 1e-30, largest_magnitude = 1e30;

/// Allowed values, for somebody who gave `value`, which the range does not contain: as describe(range), but
/// where the magnitude is the reason.
std::string describe(const Range& range, double value);

}  // namespace rubsweep::model
