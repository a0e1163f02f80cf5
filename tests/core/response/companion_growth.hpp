#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "rubsweep/core/response/lyapunov_exponent.hpp"
#include "rubsweep/core/response/proof/section_map.hpp"

namespace rubsweep::test {

/// A second state that follows a base state through the same map and is repeatedly pulled back to the
/// distance `response::separation`: Benettin's original method for Lyapunov exponents.
class Companion {
 public:
  explicit Companion(std::span<const double> base) : state_(base.size()) { start(base); }

  /// State that must be advanced by one iteration, like the base.
  std::span<double> state() { return state_; }

  /// Returns ln(distance from the base / separation), then pulls the state back along the line to the base. A
  /// distance lost in rounding counts as 1e-15, and the companion starts again.
  double pull_back(std::span<const double> base) {
    double square = 0;
    for (std::size_t i = 0; i < base.size(); ++i) square += (state_[i] - base[i]) * (state_[i] - base[i]);
    const double apart = std::sqrt(square);
    if (apart < lost_in_rounding) {
      start(base);
      return std::log(lost_in_rounding / response::separation);
    }
    for (std::size_t i = 0; i < base.size(); ++i)
      state_[i] = base[i] + (state_[i] - base[i]) * (response::separation / apart);
    return std::log(apart / response::separation);
  }

 private:
  static constexpr double lost_in_rounding = 1e-15;

  void start(std::span<const double> base) {
    const Eigen::VectorXd away = response::first_disturbance(base.size());
    for (std::size_t i = 0; i < base.size(); ++i) state_[i] = base[i] + away(static_cast<Eigen::Index>(i));
  }

  std::vector<double> state_;
};

/// Growth of a companion of the motion that starts at `section`, for any map. It is an independent check of
/// `tangent_growth`, and the only method for maps that do not belong to a scene.
inline response::Growth companion_growth(response::proof::SectionMap map, std::span<const double> section) {
  return [map = std::move(map),
          companion = Companion(section)](std::span<double> base) mutable -> std::optional<double> {
    if (!map(companion.state()) || !map(base)) return std::nullopt;
    return companion.pull_back(base);
  };
}

/// Largest Lyapunov exponent of the motion from `state` over `iterations`; empty if the map fails.
inline std::optional<response::motion::Exponent> largest_exponent(const response::proof::SectionMap& map,
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
