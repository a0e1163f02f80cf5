#include "rubsweep/core/response/lyapunov_exponent.hpp"

#include <fmt/format.h>

#include <array>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <numbers>

#include "rubsweep/core/error.hpp"

namespace rubsweep::response {
namespace {

/// A disturbance that shrinks to less than this in one turn starts anew.
constexpr double lost = 1e-10;

struct Tangent {
  proof::SceneMap& map;
  Eigen::MatrixXd direction{};  ///< tangent vector as one column
  std::vector<double> before{};

  std::optional<double> operator()(std::span<double> section) {
    if (direction.size() == 0) direction = first_disturbance(section.size()).normalized();
    before.assign(section.begin(), section.end());
    bool moved = false;
    if (!map.carry_exactly(section, direction, moved, growth_accuracy)) return std::nullopt;
    // A second run would not contain the speed at which a contact began.
    if (!moved && (map.remembers() || !by_second_run(before, section))) return std::nullopt;
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

constexpr std::size_t blocks = 8;
constexpr std::size_t fewest = 40;  ///< smallest number of contributions: four per block

double hann_mean(std::span<const double> block) {
  double sum = 0, weights = 0;
  for (std::size_t i = 0; i < block.size(); ++i) {
    const double place = (static_cast<double>(i) + 0.5) / static_cast<double>(block.size());
    const double weight = 1 - std::cos(2 * std::numbers::pi * place);
    sum += weight * block[i];
    weights += weight;
  }
  return sum / weights;
}

}  // namespace

Eigen::VectorXd first_disturbance(std::size_t states) {
  Eigen::VectorXd shares(static_cast<Eigen::Index>(states));
  double square = 0;
  for (std::size_t i = 0; i < states; ++i) {
    // Multiples of the golden ratio modulo 1: no two coordinates get equal shares, and none gets zero.
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

double bump_mean(std::span<const double> contributions) {
  double sum = 0, weights = 0;
  for (std::size_t i = 0; i < contributions.size(); ++i) {
    const double x = (static_cast<double>(i) + 0.5) / static_cast<double>(contributions.size());
    const double weight = std::exp(-1 / (x * (1 - x)));
    sum += weight * contributions[i];
    weights += weight;
  }
  return weights > 0 ? sum / weights : 0;
}

BumpMeans bump_means(std::span<const double> contributions) {
  const auto kept = contributions.subspan(contributions.size() / 5);
  return {bump_mean(kept), bump_mean(kept.first(kept.size() / 2)), bump_mean(kept.last(kept.size() / 2))};
}

motion::Exponent exponent_of(std::span<const double> contributions) {
  if (contributions.size() < fewest) {
    throw SolverError(
        fmt::format("an exponent takes {} iterations or more, got {}", fewest, contributions.size()));
  }
  const std::size_t length = (contributions.size() - contributions.size() / 5) / blocks;
  const auto kept = contributions.last(blocks * length);
  std::array<double, blocks> means{};
  double mean = 0;
  // Not Boost.Math's mean, whose rounding differs: the maps print this number.
  for (std::size_t b = 0; b < blocks; ++b) {
    means[b] = hann_mean(kept.subspan(b * length, length));
    mean += means[b] / blocks;
  }
  double variance = 0;
  for (const double m : means) variance += (m - mean) * (m - mean) / (blocks - 1);
  return {.per_revolution = mean, .error_bar = student_quantile(blocks - 1) * std::sqrt(variance / blocks)};
}

double student_quantile(std::size_t degrees_of_freedom) {
  return boost::math::quantile(boost::math::students_t(static_cast<double>(degrees_of_freedom)), 0.995);
}

}  // namespace rubsweep::response
