#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "rubsweep/response/exponent.hpp"
#include "rubsweep/response/growth.hpp"
#include "rubsweep/response/section_map.hpp"

namespace rubsweep::test {

/// Growth of a companion of the motion that starts at `section`, followed through any map: another route to
/// what `tangent_growth` finds, and the only one for maps that are not of a scene.
inline response::Growth companion_growth(response::SectionMap map, std::span<const double> section) {
  return [map = std::move(map),
          companion = response::Companion(section)](std::span<double> base) mutable -> std::optional<double> {
    if (!map(companion.state()) || !map(base)) return std::nullopt;
    return companion.pull_back(base);
  };
}

/// Exponent of the motion from `state` over `iterations`; empty when the map fails.
inline std::optional<response::Exponent> largest_exponent(const response::SectionMap& map,
                                                          std::vector<double> state, int iterations) {
  const response::Growth turn = companion_growth(map, state);
  std::vector<double> contributions;
  for (int k = 0; k < iterations; ++k) {
    const auto growth = turn(state);
    if (!growth) return std::nullopt;
    contributions.push_back(*growth);
  }
  return response::exponent_of(contributions);
}

}  // namespace rubsweep::test
