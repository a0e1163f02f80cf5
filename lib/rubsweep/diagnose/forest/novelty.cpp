#include "rubsweep/diagnose/forest/novelty.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <vector>

#include "rubsweep/batch/parallel_run.hpp"

namespace rubsweep::diagnose::forest {
namespace {

constexpr std::size_t neighbours = 3;
constexpr double farthest = 20;  ///< spreads of one feature that count

double quantile(std::vector<double> values, double share) {
  const auto place =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::ranges::nth_element(values, place);
  return *place;
}

}  // namespace

Novelty::Novelty(const Eigen::MatrixXd& cases, int threads)
    : middle_(cases.cols()),
      spread_(cases.cols()),
      cases_(cases.cols(), cases.rows()),
      distances_(cases.rows()) {
  for (Eigen::Index j = 0; j < cases.cols(); ++j) {
    const std::vector<double> values(cases.col(j).begin(), cases.col(j).end());
    middle_(j) = quantile(values, 0.5);
    // A feature that hardly ever changes still tells something where it does.
    constexpr double least_share = 0.05;
    const double all = std::sqrt((cases.col(j).array() - middle_(j)).square().mean());
    spread_(j) = std::max({quantile(values, 0.84) - quantile(values, 0.16), least_share * all, 1e-12});
  }
  for (Eigen::Index i = 0; i < cases.rows(); ++i) cases_.col(i) = scaled(cases.row(i));
  batch::parallel_run(
      static_cast<std::size_t>(cases.rows()), threads,
      [&](std::size_t i) {
        const auto k = static_cast<Eigen::Index>(i);
        distances_(k) = distance(cases_.col(k), k);
      },
      [](std::size_t) {}, std::atomic<bool>{false});
  std::sort(distances_.begin(), distances_.end());
}

Eigen::VectorXd Novelty::scaled(const Eigen::VectorXd& features) const {
  return ((features - middle_).array() / spread_.array()).cwiseMax(-farthest).cwiseMin(farthest);
}

double Novelty::distance(const Eigen::VectorXd& scaled, Eigen::Index without) const {
  std::array<double, neighbours> nearest{};
  nearest.fill(INFINITY);
  for (Eigen::Index i = 0; i < cases_.cols(); ++i) {
    const double squared = i == without ? INFINITY : (cases_.col(i) - scaled).squaredNorm();
    if (squared >= nearest.back()) continue;
    nearest.back() = squared;
    std::ranges::sort(nearest);
  }
  double sum = 0;
  for (const double squared : nearest) sum += std::sqrt(squared);
  return sum;
}

double Novelty::p_value(const Eigen::VectorXd& features) const {
  const auto nearer = std::lower_bound(distances_.begin(), distances_.end(), distance(scaled(features), -1));
  const auto as_far = static_cast<double>(distances_.end() - nearer);
  return (1 + as_far) / (1 + static_cast<double>(distances_.size()));
}

double probability_of_none(double p_value) {
  constexpr double a = 0.2;
  const double none = prior_of_none * a * std::pow(p_value, a - 1);
  return none / (none + 1 - prior_of_none);
}

}  // namespace rubsweep::diagnose::forest
