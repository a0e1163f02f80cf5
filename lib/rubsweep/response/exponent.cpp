#include "rubsweep/response/exponent.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <numbers>

#include "rubsweep/error.hpp"
#include "rubsweep/response/growth.hpp"

namespace rubsweep::response {
namespace {

constexpr std::size_t blocks = 8;
constexpr std::size_t fewest = 40;           ///< four per block
constexpr double student_quantile = 3.4995;  ///< 99 %, two-sided, blocks - 1 degrees of freedom
constexpr double lost_in_rounding = 1e-15;

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

double distance(std::span<const double> a, std::span<const double> b) {
  double square = 0;
  for (std::size_t i = 0; i < a.size(); ++i) square += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(square);
}

}  // namespace

Companion::Companion(std::span<const double> base) : state_(base.size()) { start(base); }

void Companion::start(std::span<const double> base) {
  double square = 0;
  for (std::size_t i = 0; i < state_.size(); ++i) {
    // Multiples of the golden ratio, folded: no two coordinates get equal shares, none gets nothing.
    const double share = 0.5 + std::fmod(std::numbers::phi * static_cast<double>(i + 1), 1.0);
    state_[i] = i % 3 == 1 ? -share : share;
    square += share * share;
  }
  for (std::size_t i = 0; i < state_.size(); ++i)
    state_[i] = base[i] + separation * state_[i] / std::sqrt(square);
}

double Companion::pull_back(std::span<const double> base) {
  const double apart = distance(state_, base);
  if (apart < lost_in_rounding) {
    start(base);
    return std::log(lost_in_rounding / separation);
  }
  for (std::size_t i = 0; i < state_.size(); ++i) {
    state_[i] = base[i] + (state_[i] - base[i]) * (separation / apart);
  }
  return std::log(apart / separation);
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
  for (std::size_t b = 0; b < blocks; ++b) {
    means[b] = hann_mean(kept.subspan(b * length, length));
    mean += means[b] / blocks;
  }
  double variance = 0;
  for (const double m : means) variance += (m - mean) * (m - mean) / (blocks - 1);
  return {.per_revolution = mean, .error_bar = student_quantile * std::sqrt(variance / blocks)};
}

std::optional<motion::Exponent> largest_exponent(const proof::SectionMap& map, std::vector<double> state,
                                                 int iterations) {
  const Growth turn = companion_growth(map, state);
  std::vector<double> contributions;
  for (int k = 0; k < iterations; ++k) {
    const auto growth = turn(state);
    if (!growth) return std::nullopt;
    contributions.push_back(*growth);
  }
  return exponent_of(contributions);
}

}  // namespace rubsweep::response
