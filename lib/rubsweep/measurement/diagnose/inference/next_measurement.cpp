#include "rubsweep/measurement/diagnose/inference/next_measurement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "rubsweep/maps/batch/parallel_run.hpp"
#include "rubsweep/measurement/diagnose/forest/forest.hpp"

namespace rubsweep::diagnose::inference {
namespace {

constexpr int cases_together = 240;  ///< number of cases that are simulated again
constexpr double possible = 0.02;    ///< candidates with a smaller probability are ignored

/// Entropy of a discrete distribution, in bits.
double entropy(const Eigen::VectorXd& probability) {
  double sum = 0;
  for (const double p : probability)
    if (p > 0) sum -= p * std::log2(p);
  return sum;
}

/// Systematic sampling of cases in proportion to their weights, from the possible candidates only.
std::vector<std::size_t> draw_cases(const Diagnosis& diagnosis) {
  const auto counts = [&](std::size_t i) {
    const auto c = static_cast<Eigen::Index>(diagnosis.set.cases[i].candidate);
    return diagnosis.posterior.probability(c) >= possible;
  };
  double all = 0;
  for (std::size_t i = 0; i < diagnosis.set.cases.size(); ++i)
    if (counts(i)) all += diagnosis.posterior.weight(static_cast<Eigen::Index>(i));
  std::vector<std::size_t> drawn;
  if (all <= 0) return drawn;
  double sum = 0;
  for (std::size_t i = 0; i < diagnosis.set.cases.size(); ++i) {
    if (!counts(i)) continue;
    sum += diagnosis.posterior.weight(static_cast<Eigen::Index>(i));
    while (static_cast<double>(drawn.size()) + 0.5 < sum / all * cases_together) drawn.push_back(i);
  }
  return drawn;
}

double information_of(const DiagnosisProblem& changed, const Diagnosis& diagnosis,
                      const std::vector<std::size_t>& drawn, int threads) {
  std::vector<std::optional<Eigen::VectorXd>> seen(drawn.size());
  batch::parallel_run(drawn.size(), threads, [&](std::size_t first) {
    if (first > 0 && drawn[first] == drawn[first - 1]) return;
    thread_local response::spectrum::SpectrumWorkspace workspace;
    SimulatedCase again = diagnosis.set.cases[drawn[first]];
    auto motion = run_again(changed, again, changed.speed_hz, changed.turns, true, workspace);
    if (!motion) return;
    again.further.clear();
    again.motion = *std::move(motion);
    // A case with a large weight is drawn several times in a row, and measured each time.
    for (std::size_t k = first; k < drawn.size() && drawn[k] == drawn[first]; ++k)
      seen[k] = features::values_of(observe(changed, again, k, workspace).seen.features);
  });
  forest::LabelledSamples samples{.classes = static_cast<int>(changed.candidates.size())};
  std::vector<Eigen::VectorXd> rows;
  for (std::size_t k = 0; k < drawn.size(); ++k) {
    if (!seen[k]) continue;
    rows.push_back(*seen[k]);
    samples.label.push_back(static_cast<int>(diagnosis.set.cases[drawn[k]].candidate));
  }
  if (rows.empty()) return 0;
  samples.features.resize(static_cast<Eigen::Index>(rows.size()), rows.front().size());
  for (std::size_t k = 0; k < rows.size(); ++k)
    samples.features.row(static_cast<Eigen::Index>(k)) = rows[k].transpose();
  samples.weight = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(rows.size()));
  const Eigen::MatrixXd told =
      forest::Forest(samples, {.seed = changed.seed, .threads = threads}).out_of_bag_probabilities();
  Eigen::VectorXd now = Eigen::VectorXd::Zero(samples.classes);
  double left = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    now(samples.label[k]) += 1.0 / static_cast<double>(rows.size());
    // With so few cases the forest cannot tell smaller probabilities from zero.
    constexpr double least = 0.01;
    left -= std::log2(std::max(least, told(static_cast<Eigen::Index>(k), samples.label[k])));
  }
  return std::max(0.0, entropy(now) - left / static_cast<double>(rows.size()));
}

}  // namespace

std::vector<NextMeasurement> next_measurements(const DiagnosisProblem& problem, const Diagnosis& diagnosis,
                                               int threads) {
  if ((diagnosis.posterior.probability.array() >= possible).count() < 2) return {};
  const std::vector<std::size_t> drawn = draw_cases(diagnosis);
  if (drawn.empty()) return {};
  std::vector<std::pair<std::string, DiagnosisProblem>> options;
  DiagnosisProblem alone = problem;
  alone.further_speeds_hz.clear();
  for (const double factor : {0.9, 1.1}) {
    DiagnosisProblem changed = alone;
    changed.speed_hz *= factor;
    changed.measuring = at_speed(changed.measuring, factor);
    options.emplace_back(fmt::format("at {:.4g} Hz ({:.0f} rpm)", changed.speed_hz, 60 * changed.speed_hz),
                         changed);
  }
  DiagnosisProblem longer = alone;
  longer.turns *= 4;
  options.emplace_back(fmt::format("{} turns instead of {}", longer.turns, problem.turns), longer);
  if (problem.measuring.probes == 1) {
    DiagnosisProblem second = alone;
    second.measuring.probes = 2;
    options.emplace_back("a second probe", second);
  }
  std::vector<NextMeasurement> measurements;
  measurements.reserve(options.size());
  for (const auto& [name, changed] : options)
    measurements.push_back({name, information_of(changed, diagnosis, drawn, threads)});
  std::ranges::stable_sort(measurements, std::greater{}, &NextMeasurement::information_bits);
  return measurements;
}

}  // namespace rubsweep::diagnose::inference
