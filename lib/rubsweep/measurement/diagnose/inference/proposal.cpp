#include "rubsweep/measurement/diagnose/inference/proposal.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <utility>

namespace rubsweep::diagnose::inference {
namespace {

/// Kernels narrower than this find nothing new.
constexpr double least_deviation = 0.02;

/// Share of the prior's density that a kernel may leave out.
constexpr double negligible = 1e-6;

/// A number folded back into [0, 1] at both ends.
double folded(double x) {
  const double twice = x - 2 * std::floor(x / 2);
  return twice > 1 ? 2 - twice : twice;
}

double gaussian(double x, double deviation) {
  return std::exp(-x * x / (2 * deviation * deviation)) / (deviation * std::sqrt(2 * std::numbers::pi));
}

/// Density of the folded kernel: both faces are mirrors, and a kernel reaches their next images.
double folded_density(double x, double centre, double deviation) {
  double sum = 0;
  for (const double image : {centre, -centre, 2 - centre, centre - 2, centre + 2})
    sum += gaussian(x - image, deviation);
  return sum;
}

}  // namespace

Proposal::Proposal(const Candidate& candidate, std::vector<Point> centres, std::vector<double> weight)
    : centres_(std::move(centres)), weight_(std::move(weight)) {
  const double all = std::accumulate(weight_.begin(), weight_.end(), 0.0);
  for (double& w : weight_) w /= all;
  for (std::size_t j = 0; j < unknown_count; ++j) {
    if (candidate.spreads[j].low == candidate.spreads[j].high) continue;
    unknown_.push_back(j);
    double mean = 0, square = 0;
    for (std::size_t i = 0; i < centres_.size(); ++i) {
      mean += weight_[i] * centres_[i][j];
      square += weight_[i] * centres_[i][j] * centres_[i][j];
    }
    constexpr double most_deviation = 0.3;
    deviation_[j] =
        std::clamp(std::sqrt(2 * std::max(0.0, square - mean * mean)), least_deviation, most_deviation);
  }
}

Point Proposal::draw(RandomStream& random) const {
  double left = random.uniform();
  std::size_t chosen = 0;
  while (chosen + 1 < centres_.size() && left >= weight_[chosen]) left -= weight_[chosen++];
  Point unit = centres_[chosen];
  for (const std::size_t j : unknown_) unit[j] = folded(unit[j] + deviation_[j] * random.normal());
  return unit;
}

double Proposal::density(const Point& unit) const {
  double sum = 0;
  for (std::size_t i = 0; i < centres_.size(); ++i) {
    if (weight_[i] == 0) continue;
    double product = weight_[i];
    for (const std::size_t j : unknown_) {
      product *= folded_density(unit[j], centres_[i][j], deviation_[j]);
      if (product < negligible) break;
    }
    sum += product;
  }
  return sum;
}

}  // namespace rubsweep::diagnose::inference
