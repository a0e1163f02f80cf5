#include "rubsweep/measurement/diagnose/forest/novelty.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "rubsweep/maps/batch/parallel_run.hpp"

namespace rubsweep::diagnose::forest {
namespace {

constexpr double farthest = 20;  ///< limit for the distance in one feature, in spreads

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
      of_cases_(static_cast<std::size_t>(cases.rows())) {
  for (Eigen::Index j = 0; j < cases.cols(); ++j) {
    const std::vector<double> values(cases.col(j).begin(), cases.col(j).end());
    middle_(j) = quantile(values, 0.5);
    // Smallest spread of a feature: a feature that is nearly constant is informative in the few cases where
    // it differs.
    constexpr double least_share = 0.05;
    const double all = std::sqrt((cases.col(j).array() - middle_(j)).square().mean());
    spread_(j) = std::max({quantile(values, 0.84) - quantile(values, 0.16), least_share * all, 1e-12});
  }
  for (Eigen::Index i = 0; i < cases.rows(); ++i) cases_.col(i) = scaled(cases.row(i));
  batch::parallel_run(
      static_cast<std::size_t>(cases.rows()), threads,
      [&](std::size_t i) {
        const auto k = static_cast<Eigen::Index>(i);
        of_cases_[i] = nearest(cases_.col(k), k);
      },
      [](std::size_t) {}, std::atomic<bool>{false});
  for (std::size_t i = 0; i < of_cases_.size(); ++i)
    apartness_.push_back(apartness(of_cases_[i], static_cast<Eigen::Index>(i)));
  std::ranges::sort(apartness_);
}

Eigen::VectorXd Novelty::scaled(const Eigen::VectorXd& features) const {
  return ((features - middle_).array() / spread_.array()).cwiseMax(-farthest).cwiseMin(farthest);
}

Novelty::Nearest Novelty::nearest(const Eigen::VectorXd& scaled, Eigen::Index without) const {
  Nearest found;
  found.fill({INFINITY, 0});
  for (Eigen::Index i = 0; i < cases_.cols(); ++i) {
    const double squared = i == without ? INFINITY : (cases_.col(i) - scaled).squaredNorm();
    if (squared >= found.back().first) continue;
    found.back() = {squared, i};
    std::ranges::sort(found);
  }
  for (auto& [distance, i] : found) distance = std::sqrt(distance);
  return found;
}

double Novelty::apartness(const Nearest& nearest, Eigen::Index self) const {
  const auto mean = [](const Nearest& of, Eigen::Index without) {
    double sum = 0;
    std::size_t counted = 0;
    for (const auto& [distance, i] : of)
      if (i != without && counted < neighbours) {
        sum += distance;
        ++counted;
      }
    return sum / static_cast<double>(neighbours);
  };
  double usual = 0;
  for (std::size_t k = 0; k < neighbours; ++k)
    usual +=
        mean(of_cases_[static_cast<std::size_t>(nearest[k].second)], self) / static_cast<double>(neighbours);
  return mean(nearest, -1) / std::max(usual, 1e-300);
}

double Novelty::p_value(const Eigen::VectorXd& features) const {
  const double here = apartness(nearest(scaled(features), -1), -1);
  const auto as_far = apartness_.end() - std::ranges::lower_bound(apartness_, here);
  return (1 + static_cast<double>(as_far)) / (1 + static_cast<double>(apartness_.size()));
}

}  // namespace rubsweep::diagnose::forest
