#pragma once

#include <string>

#include "rubsweep/core/model/range.hpp"

namespace rubsweep::model {

/// Bounds of the magnitude of every number of a machine that is not 0. They are far wider than anything ever
/// built, yet narrow enough that products of several numbers stay finite and keep their digits. Used by
/// `contains`.
inline constexpr double smallest_magnitude = 1e-30, largest_magnitude = 1e30;

/// Allowed values as text for a message about `value`, which lies outside the range: describe(range), or the
/// bounds of magnitude where these are the reason.
std::string describe(const Range& range, double value);

}  // namespace rubsweep::model
