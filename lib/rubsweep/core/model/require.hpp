#pragma once

#include <array>
#include <optional>
#include <string>

#include "rubsweep/core/model/key.hpp"
#include "rubsweep/core/model/range.hpp"

namespace rubsweep::model {

/// Problem of a part whose numbers are each in range but contradict each other.
struct PartProblem {
  const char* key = nullptr;      ///< key to blame
  const char* wrong = nullptr;    ///< end of a sentence about the key
  const char* allowed = nullptr;  ///< end of "allowed: "
};

/// Throws ConfigError where there is a problem; `path` precedes its key.
void refuse(const std::optional<PartProblem>& problem, const std::string& path);

/// Throws ConfigError that names the key `path` where `value` is missing (NaN) or outside of the range.
void require(const std::string& path, double value, const Range& range);

/// The same check for an optional value; an empty value passes.
inline void require(const std::string& path, const std::optional<double>& value, const Range& range) {
  if (value) require(path, *value, range);
}

/// The same check for both numbers of a pair, which must be finite.
inline void require(const std::string& path, const std::array<double, 2>& values, const NumberPair&) {
  for (const double value : values) require(path, value, any_finite);
}

}  // namespace rubsweep::model
