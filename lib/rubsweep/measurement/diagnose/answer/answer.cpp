#include "rubsweep/measurement/diagnose/answer/answer.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>
#include <functional>
#include <numbers>
#include <numeric>
#include <utility>

namespace rubsweep::diagnose::answer {
namespace {

using Complex = std::complex<double>;

Complex correlation(const MotionLines& recorded, const MotionLines& simulated, double angle_rad) {
  Complex sum = 0;
  const int last = std::min(recorded.last(), simulated.last());
  const Complex step = std::polar(1.0, angle_rad / recorded.turns);
  Complex shift = std::polar(1.0, -last * angle_rad / recorded.turns);
  for (int k = -last; k <= last; ++k, shift *= step)
    if (k != 0) sum += std::conj(recorded.at(k)) * simulated.at(k) * shift;
  return sum;
}

using inference::Diagnosis;
using inference::DiagnosisProblem;

std::vector<NumberInterval> numbers_of(const std::vector<inference::QuantityMarginal>& marginals) {
  std::vector<NumberInterval> numbers;
  numbers.reserve(marginals.size());
  for (const auto& [quantity, marginal] : marginals)
    numbers.push_back({std::string(to_string(quantity)), marginal.quantile(0.5), marginal.quantile(0.025),
                       marginal.quantile(0.975)});
  return numbers;
}

/// Weights of a candidate's cases: their posterior weights, or equal weights where too few cases resemble the
/// recording.
Eigen::ArrayXd speaking_weights(const Diagnosis& diagnosis, std::size_t candidate) {
  constexpr double fewest = 10;
  Eigen::ArrayXd weight = weights_of(diagnosis, candidate).array();
  if (inference::effective_cases(weight.matrix()) >= fewest) return weight;
  for (Eigen::Index i = 0; i < weight.size(); ++i)
    weight(i) = diagnosis.set.cases[static_cast<std::size_t>(i)].candidate == candidate ? 1 : 0;
  return weight;
}

/// Features that best separate the two likeliest candidates, on the assumption of normal distributions.
std::vector<DecidingFeature> deciding_features(const Diagnosis& diagnosis,
                                               const features::DescribedMotion& seen, std::size_t first,
                                               std::size_t second) {
  constexpr std::size_t most = 5;
  const Eigen::ArrayXd weights[2] = {speaking_weights(diagnosis, first), speaking_weights(diagnosis, second)};
  if (weights_of(diagnosis, first).sum() == 0 || weights[1].sum() == 0) return {};
  std::vector<DecidingFeature> features;
  for (std::size_t j = 0; j < seen.features.size(); ++j) {
    const auto column = diagnosis.observed.features.col(static_cast<Eigen::Index>(j)).array();
    DecidingFeature feature{.name = seen.features[j].name, .recorded = seen.features[j].value};
    double mean[2], spread[2];
    for (int k = 0; k < 2; ++k) {
      const Eigen::ArrayXd& weight = weights[k];
      mean[k] = (weight * column).sum() / weight.sum();
      spread[k] = std::sqrt((weight * (column - mean[k]).square()).sum() / weight.sum()) + 1e-6;
    }
    feature.first = mean[0];
    feature.second = mean[1];
    feature.first_spread = spread[0];
    feature.second_spread = spread[1];
    const auto distance = [&](int k) {
      const double off = (feature.recorded - mean[k]) / spread[k];
      return off * off + 2 * std::log(spread[k]);
    };
    feature.nearer = distance(1) - distance(0);
    features.push_back(feature);
  }
  std::ranges::stable_sort(features, std::greater{}, &DecidingFeature::nearer);
  features.resize(std::min(features.size(), most));
  return features;
}

/// The motion of a case as the probes would show it without noise.
MotionLines shown(const DiagnosisProblem& problem, const Diagnosis& diagnosis, std::size_t i) {
  MotionLines lines = diagnosis.set.cases[i].motion.lines;
  if (problem.measuring.probes == 2) return lines;
  const MotionLines plane = lines;
  const auto turn = std::polar(1.0, -diagnosis.observed.probe_angle_rad(static_cast<Eigen::Index>(i)));
  for (int k = -lines.last(); k <= lines.last(); ++k)
    lines.at(k) = (turn * plane.at(k) + std::conj(turn * plane.at(-k))) / 2.0;
  return lines;
}

/// Cases that leave the smallest share of the recorded energy unexplained, among the cases with the largest
/// weights.
std::vector<BestMotion> best_motions(const DiagnosisProblem& problem, const Diagnosis& diagnosis,
                                     const MotionLines& recorded) {
  constexpr std::size_t looked_at = 25, most = 3;
  std::vector<std::size_t> order(diagnosis.set.cases.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::greater{}, [&](std::size_t i) {
    return diagnosis.posterior.weight(static_cast<Eigen::Index>(i));
  });
  order.resize(std::min(order.size(), looked_at));
  std::vector<BestMotion> best;
  best.reserve(order.size());
  for (const std::size_t i : order)
    best.push_back({problem.candidates[diagnosis.set.cases[i].candidate].name,
                    lay_over(recorded, shown(problem, diagnosis, i), problem.measuring.probes == 2)});
  std::ranges::stable_sort(best, {}, [](const BestMotion& motion) { return motion.overlay.unexplained; });
  best.resize(std::min(best.size(), most));
  return best;
}

}  // namespace

Overlay lay_over(const MotionLines& recorded, const MotionLines& simulated, bool plane) {
  constexpr int begins_of_a_turn = 64;
  const auto agreement = [&](const Complex& c) { return plane ? std::abs(c) : c.real(); };
  double angle = 0;
  Complex best = correlation(recorded, simulated, 0);
  for (int j = 1; j < begins_of_a_turn * recorded.turns; ++j) {
    const double at = 2 * std::numbers::pi * j / begins_of_a_turn;
    const Complex c = correlation(recorded, simulated, at);
    if (agreement(c) > agreement(best)) {
      best = c;
      angle = at;
    }
  }
  const double scale = size_of(recorded) / size_of(simulated);
  const Complex turn = plane ? std::conj(best) / std::abs(best) : 1;
  Overlay overlay{{recorded.turns, Eigen::VectorXcd::Zero(recorded.amplitude.size())}, 0};
  const int last = std::min(recorded.last(), simulated.last());
  double left = 0;
  for (int k = -recorded.last(); k <= recorded.last(); ++k) {
    if (k == 0) continue;
    if (std::abs(k) <= last)
      overlay.simulated.at(k) = scale * turn * std::polar(1.0, k * angle / recorded.turns) * simulated.at(k);
    left += std::norm(recorded.at(k) - overlay.simulated.at(k));
  }
  overlay.unexplained = left / (size_of(recorded) * size_of(recorded));
  return overlay;
}

Answer answer_of(const DiagnosisProblem& problem, const Diagnosis& diagnosis,
                 const features::DescribedMotion& seen, const MotionLines& recorded, RecordingFacts facts,
                 std::vector<inference::NextMeasurement> next) {
  Answer answer{.recording = std::move(facts)};
  answer.clipped = std::ranges::any_of(answer.recording.findings, [](const std::string& finding) {
    return finding.find("clipped") != std::string::npos;
  });
  answer.none = answer.clipped ? 1 : diagnosis.posterior.none;
  answer.p_value = diagnosis.p_value;
  answer.size_fits = diagnosis.posterior.weight.sum() > 0;
  answer.cases = diagnosis.set.cases.size();
  std::vector<std::size_t> order(problem.candidates.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto probability = [&](std::size_t c) {
    return diagnosis.posterior.probability(static_cast<Eigen::Index>(c));
  };
  std::ranges::stable_sort(order, std::greater{}, probability);
  const auto error = [&](std::size_t place) {
    return diagnosis.standard_error.size() == 0 || answer.clipped
               ? std::nullopt
               : std::optional(diagnosis.standard_error(static_cast<Eigen::Index>(place)));
  };
  answer.none_standard_error = error(order.size());
  for (const std::size_t c : order)
    answer.candidates.push_back({problem.candidates[c].name, problem.candidates[c].cause,
                                 (1 - answer.none) * probability(c), numbers_of(diagnosis.marginals[c]),
                                 error(c)});
  if (order.size() > 1) answer.deciding = deciding_features(diagnosis, seen, order[0], order[1]);
  answer.best = best_motions(problem, diagnosis, recorded);
  answer.next = std::move(next);
  return answer;
}

}  // namespace rubsweep::diagnose::answer
