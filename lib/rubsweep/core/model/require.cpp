#include "rubsweep/core/model/require.hpp"

#include <fmt/format.h>

#include <cmath>

#include "rubsweep/core/error.hpp"

namespace rubsweep::model {

void require(const std::string& path, double value, const Range& range) {
  if (contains(range, value)) return;
  if (std::isnan(value)) throw ConfigError(fmt::format("{}: missing, allowed: {}", path, describe(range)));
  throw ConfigError(fmt::format("{}: {} is out of range, allowed: {}", path, value, describe(range, value)));
}

void refuse(const std::optional<PartProblem>& problem, const std::string& path) {
  if (problem)
    throw ConfigError(
        fmt::format("{}{}: {}, allowed: {}", path, problem->key, problem->wrong, problem->allowed));
}

}  // namespace rubsweep::model
