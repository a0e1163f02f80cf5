#include "rubsweep/response/growth.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <memory>

#include "rubsweep/response/exponent.hpp"

namespace rubsweep::response {
namespace {

/// A disturbance that a turn shrinks by more than this starts anew.
constexpr double lost = 1e-10;

struct Tangent {
  proof::SceneMap& map;
  Eigen::MatrixXd direction{};  ///< one column
  std::vector<double> before{};

  std::optional<double> operator()(std::span<double> section) {
    if (direction.size() == 0) start(section.size());
    before.assign(section.begin(), section.end());
    bool exact = false;
    if (!map.carry_exactly(section, direction, exact)) return std::nullopt;
    if (!exact && !by_companion(before, section)) return std::nullopt;
    const double factor = direction.norm();
    if (!(factor > lost)) {
      start(section.size());
      return std::log(lost);
    }
    direction /= factor;
    return std::log(factor);
  }

  bool by_companion(std::span<double> section, std::span<const double> after) {
    for (std::size_t i = 0; i < section.size(); ++i)
      section[i] += Companion::separation * direction(static_cast<Eigen::Index>(i), 0);
    if (!map(section)) return false;
    for (std::size_t i = 0; i < section.size(); ++i)
      direction(static_cast<Eigen::Index>(i), 0) = (section[i] - after[i]) / Companion::separation;
    return true;
  }

  void start(std::size_t states) {
    std::vector<double> origin(states, 0.0);
    Companion companion(origin);
    const auto state = companion.state();
    direction =
        Eigen::Map<const Eigen::VectorXd>(state.data(), static_cast<Eigen::Index>(states)).normalized();
  }
};

}  // namespace

Growth companion_growth(proof::SectionMap map, std::span<const double> section) {
  return [map = std::move(map),
          companion = Companion(section)](std::span<double> base) mutable -> std::optional<double> {
    if (!map(companion.state()) || !map(base)) return std::nullopt;
    return companion.pull_back(base);
  };
}

Growth tangent_growth(proof::SceneMap& map) { return Tangent{map}; }

}  // namespace rubsweep::response
