#include "rubsweep/core/response/growth.hpp"

#include <cmath>
#include <numbers>

namespace rubsweep::response {
namespace {

/// A disturbance that a turn shrinks by more than this starts anew.
constexpr double lost = 1e-10;

struct Tangent {
  proof::SceneMap& map;
  Eigen::MatrixXd direction{};  ///< one column
  std::vector<double> before{};

  std::optional<double> operator()(std::span<double> section) {
    if (direction.size() == 0) direction = first_disturbance(section.size()).normalized();
    before.assign(section.begin(), section.end());
    bool moved = false;
    if (!map.carry_exactly(section, direction, moved, growth_accuracy)) return std::nullopt;
    if (!moved && !by_second_run(before, section)) return std::nullopt;
    return take_growth(direction);
  }

  bool by_second_run(std::span<double> section, std::span<const double> after) {
    for (std::size_t i = 0; i < section.size(); ++i)
      section[i] += separation * direction(static_cast<Eigen::Index>(i), 0);
    if (!map(section)) return false;
    for (std::size_t i = 0; i < section.size(); ++i)
      direction(static_cast<Eigen::Index>(i), 0) = (section[i] - after[i]) / separation;
    return true;
  }
};

}  // namespace

Eigen::VectorXd first_disturbance(std::size_t states) {
  Eigen::VectorXd shares(static_cast<Eigen::Index>(states));
  double square = 0;
  for (std::size_t i = 0; i < states; ++i) {
    // Multiples of the golden ratio, folded: no two coordinates get equal shares, none gets nothing.
    const double share = 0.5 + std::fmod(std::numbers::phi * static_cast<double>(i + 1), 1.0);
    shares(static_cast<Eigen::Index>(i)) = i % 3 == 1 ? -share : share;
    square += share * share;
  }
  return separation * shares / std::sqrt(square);
}

double take_growth(Eigen::MatrixXd& direction) {
  const double factor = direction.norm();
  if (!(factor > lost)) {
    direction = first_disturbance(static_cast<std::size_t>(direction.size())).normalized();
    return std::log(lost);
  }
  direction /= factor;
  return std::log(factor);
}

Growth tangent_growth(proof::SceneMap& map) { return Tangent{map}; }

}  // namespace rubsweep::response
