#pragma once

#include <string>

#include "rubsweep/model/range.hpp"

namespace rubsweep::model {

/// Throws ConfigError that names the key `path` where `value` is missing (NaN) or outside of the range.
void require(const std::string& path, double value, const Range& range);

}  // namespace rubsweep::model
