#pragma once

#include <optional>
#include <string>

#include "rubsweep/core/model/range.hpp"

namespace rubsweep::model {

/// Problem of the numbers of one part together, each of which is in its range.
struct PartProblem {
  const char* key = nullptr;      ///< the one to blame
  const char* wrong = nullptr;    ///< finishes a sentence about it
  const char* allowed = nullptr;  ///< finishes "allowed: "
};

/// Throws ConfigError that names the key `path` where `value` is missing (NaN) or outside of the range.
void require(const std::string& path, double value, const Range& range);

/// The same where there is a value.
inline void require(const std::string& path, const std::optional<double>& value, const Range& range) {
  if (value) require(path, *value, range);
}

}  // namespace rubsweep::model
