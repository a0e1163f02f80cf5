#pragma once

#include <string>

#include "rubsweep/core/model/range.hpp"

namespace rubsweep::model {

/// No number of a machine is larger, or smaller without being 0: far wider than anything that was ever built,
/// yet so narrow that products of several numbers stay finite and keep their digits. `contains` goes by it.
inline constexpr double smallest_magnitude = 1e-30, largest_magnitude = 1e30;

/// Allowed values, for somebody who gave `value`, which the range does not contain: as describe(range), but
/// where the magnitude is the reason.
std::string describe(const Range& range, double value);

}  // namespace rubsweep::model
