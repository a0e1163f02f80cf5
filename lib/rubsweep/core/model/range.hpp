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

bool contains(const Range& range, double value);  ///< True when `value` is finite and inside the interval.

/// Allowed values, in words that finish "allowed: ", e.g. "a number > 0" or "a number >= 0 and <= 1".
std::string describe(const Range& range);

/// Marks a number that has no default and must be given. A signalling NaN, so that using it raises an error.
inline constexpr double required = std::numeric_limits<double>::signaling_NaN();

/// Bounds of the magnitude of every number of a machine that is not 0. They are far wider than anything ever
/// built, yet narrow enough that products of several numbers stay finite and keep their digits. Used by
/// `contains`.
inline constexpr double smallest_magnitude = 1e-30, largest_magnitude = 1e30;

/// Allowed values as text for a message about `value`, which lies outside the range: describe(range), or the
/// bounds of magnitude where these are the reason.
std::string describe(const Range& range, double value);

}  // namespace rubsweep::model
