#pragma once

#include <optional>
#include <string>

#include "rubsweep/core/model/range.hpp"

namespace rubsweep::model {

/// Problem of a part whose numbers are each in range but contradict each other.
struct PartProblem {
  const char* key = nullptr;      ///< key to blame
  const char* wrong = nullptr;    ///< end of a sentence about the key
  const char* allowed = nullptr;  ///< end of "allowed: "
};

/// Throws ConfigError that names the key `path` where `value` is missing (NaN) or outside of the range.
void require(const std::string& path, double value, const Range& range);

/// The same check for an optional value; an empty value passes.
inline void require(const std::string& path, const std::optional<double>& value, const Range& range) {
  if (value) require(path, *value, range);
}

}  // namespace rubsweep::model
