#include "rubsweep/measurement/diagnose/inference/posterior.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <vector>

#include "rubsweep/maps/batch/parallel_run.hpp"
#include "rubsweep/measurement/diagnose/forest/novelty.hpp"
#include "rubsweep/measurement/diagnose/other_cause.hpp"
#include "rubsweep/measurement/diagnose/random_stream.hpp"

namespace rubsweep::diagnose::inference {
namespace {

constexpr double prior_of_none = 1.0 / 6;  ///< Prior probability of "none of these".

/// Vibrations of other causes for each case that a candidate has on average: they are the most various class,
/// and need no simulation.
constexpr std::size_t vibrations_per_case = 3;

/// Smallest width of a size interval, in decades. Simulated sizes are discrete, and some must lie inside.
constexpr double least_decades = 0.08;

bool inside(const Spread& spread, double value) { return value >= spread.low && value <= spread.high; }

double decades(const Spread& spread) { return std::log10(spread.high / spread.low); }

Spread widened(const Spread& spread) {
  const double factor = std::pow(10, std::max(0.0, least_decades - decades(spread)) / 2);
  return {spread.low / factor, spread.high * factor, true};
}

/// Share of the range of whirl ratios for which a quiet whirl of this radius lies within the range of
/// clearances. A quiet whirl has the same shape at all whirl ratios.
double share_of_whirl_ratios(const Spread& ratios, const Spread& clearances, double radius_m) {
  const double low = std::max(ratios.low, radius_m / clearances.high),
               high = std::min(ratios.high, radius_m / clearances.low);
  return low < high ? decades({low, high}) / decades(ratios) : 0;
}

/// Density of a size that another cause gives, relative to the density of one candidate's sizes as in
/// density_of_size. No stop holds a whirl of another cause, so that it may be larger than the clearance.
double density_of_another_cause(const DiagnosisProblem& problem, double size_m) {
  constexpr Spread ratios{0.01, 3, true};
  double sum = 0;
  for (std::size_t c = 0; c < problem.candidates.size(); ++c)
    sum +=
        problem.prior[c] * share_of_whirl_ratios(ratios, widened(problem.candidates[c].clearance_m), size_m);
  return sum;
}

/// Smallest probability of a candidate: a forest of so many cases cannot tell smaller values from zero.
constexpr double least_probability = 1e-3;

/// Raises probabilities to a power and normalises them.
Eigen::RowVectorXd sharpened(const Eigen::RowVectorXd& probability, double power) {
  const Eigen::RowVectorXd raised = (probability.array() + least_probability).pow(power);
  return raised / raised.sum();
}

/// Power, at most 1, that maximises the likelihood of the true candidates of the cases (temperature scaling;
/// Guo et al. 2017). Each case is judged by the trees that did not draw it. These are few, so they are less
/// certain than the whole forest, and a power above 1 would make the whole forest too certain.
double best_sharpness(const Eigen::MatrixXd& out_of_bag, const std::vector<int>& label,
                      const Eigen::VectorXd& weight) {
  const auto loss = [&](double power) {
    double sum = 0;
    for (Eigen::Index i = 0; i < out_of_bag.rows(); ++i)
      if (out_of_bag.row(i).sum() > 0)
        sum -= weight(i) * std::log(sharpened(out_of_bag.row(i), power)(label[static_cast<std::size_t>(i)]));
    return sum;
  };
  constexpr int bits = 20;
  return boost::math::tools::brent_find_minima(loss, 0.2, 1.0, bits).first;
}

/// Mean position of a vibration of another cause, in units of its 1X amplitude; a load may move the shaft.
std::complex<double> mean_of_another_cause(std::uint64_t seed, std::uint64_t index) {
  RandomStream random(seed, index, DrawPurpose::of_mean);
  const double distance = std::pow(10, -3 * random.uniform());
  return std::polar(distance, 2 * std::numbers::pi * random.uniform());
}

/// Features of vibrations of other causes as the instrument measures them, one row each.
Eigen::MatrixXd features_of_other_causes(const DiagnosisProblem& problem, std::size_t count, int threads) {
  std::vector<Eigen::VectorXd> rows(count);
  batch::parallel_run(count, threads, [&](std::size_t k) {
    thread_local response::spectrum::SpectrumWorkspace workspace;
    RandomStream random(problem.seed, k, DrawPurpose::of_another_cause);
    MotionLines lines = vibration_of_another_cause(problem.turns, random, workspace);
    if (problem.measuring.from_rest) lines.at(0) = mean_of_another_cause(problem.seed, k);
    ObservedCase observation;
    const MotionLines seen = diagnose::observed(up_to(lines, seen_order(problem.measuring)),
                                                problem.measuring, random, observation.probe_angle_rad);
    observation.seen = features::describe(seen, view_of(problem.measuring), workspace);
    RandomStream elsewhere(problem.seed, k, DrawPurpose::of_further_speed);
    for (std::size_t stretch = 0; stretch < problem.further_speeds_hz.size(); ++stretch)
      observe_further(problem, stretch, vibration_at_another_speed(lines, elsewhere, workspace),
                      size_of(lines), elsewhere, observation, workspace);
    rows[k] = features::values_of(observation.seen.features);
  });
  Eigen::MatrixXd features(static_cast<Eigen::Index>(count), rows.front().size());
  for (std::size_t k = 0; k < count; ++k) features.row(static_cast<Eigen::Index>(k)) = rows[k].transpose();
  return features;
}

/// Training samples: each case has the label of its candidate; vibrations of other causes are the last class.
/// All classes weigh the same, whatever their priors.
forest::LabelledSamples samples_of(const DiagnosisProblem& problem, const CaseSet& set,
                                   const ObservedCases& observed) {
  const Eigen::Index cases = observed.features.rows(), others = observed.of_other_causes.rows();
  const int candidates = static_cast<int>(problem.candidates.size());
  forest::LabelledSamples samples{Eigen::MatrixXd(cases + others, observed.features.cols()),
                                  {},
                                  Eigen::VectorXd(cases + others),
                                  candidates + 1};
  samples.features << observed.features, observed.of_other_causes;
  samples.weight.head(cases) = prior_weights(problem, set);
  samples.weight.tail(others).setConstant(1 / static_cast<double>(others));
  samples.weight /= samples.classes;
  for (const SimulatedCase& one : set.cases) samples.label.push_back(static_cast<int>(one.candidate));
  samples.label.resize(static_cast<std::size_t>(cases + others), candidates);
  return samples;
}

}  // namespace

double density_of_size(const DiagnosisProblem& problem, const SimulatedCase& one, double case_size_m,
                       double seen_size_m) {
  const Candidate& candidate = problem.candidates[one.candidate];
  const double clearance = simulated_clearance_m(candidate) * seen_size_m / case_size_m;
  const Spread clearances = widened(candidate.clearance_m);
  double density = inside(clearances, clearance) ? 1 : 0;
  if (candidate.cause == Cause::no_rub)
    density =
        share_of_whirl_ratios(spread_of(candidate, Unknown::whirl_ratio), clearances,
                              clearance * value_of(values_at(candidate, one.unit), Unknown::whirl_ratio));
  if (!problem.eccentricity_m) return density;
  const Spread eccentricities = widened(*problem.eccentricity_m);
  if (!inside(eccentricities, one.motion.eccentricity_m * seen_size_m / case_size_m)) return 0;
  return density * decades(clearances) / decades(eccentricities);
}

ObservedCases observed_cases(const DiagnosisProblem& problem, const CaseSet& set, int threads) {
  std::vector<ObservedCase> seen(set.cases.size());
  batch::parallel_run(seen.size(), threads, [&](std::size_t i) {
    thread_local response::spectrum::SpectrumWorkspace workspace;
    seen[i] = observe(problem, set.cases[i], i, workspace);
  });
  ObservedCases observed;
  if (seen.empty()) return observed;
  observed.of_other_causes = features_of_other_causes(
      problem, vibrations_per_case * seen.size() / problem.candidates.size() + 1, threads);
  const auto all = static_cast<Eigen::Index>(seen.size());
  observed.features.resize(all, static_cast<Eigen::Index>(seen.front().seen.features.size()));
  for (auto* column : {&observed.size_m, &observed.direction_rad, &observed.probe_angle_rad})
    column->resize(all);
  for (Eigen::Index row = 0; row < all; ++row) {
    const auto& [described, probe_angle_rad] = seen[static_cast<std::size_t>(row)];
    observed.features.row(row) = features::values_of(described.features).transpose();
    observed.size_m(row) = described.size_m;
    observed.direction_rad(row) = described.direction_rad;
    observed.probe_angle_rad(row) = probe_angle_rad;
  }
  return observed;
}

Posterior posterior_of(const DiagnosisProblem& problem, const CaseSet& set, const ObservedCases& observed,
                       const features::DescribedMotion& seen, int threads, double evidence_power) {
  const forest::LabelledSamples samples = samples_of(problem, set, observed);
  const Eigen::VectorXd here = features::values_of(seen.features);
  Posterior posterior;
  posterior.forest = std::make_shared<const forest::Forest>(
      samples, forest::ForestOptions{.seed = problem.seed, .threads = threads});
  Eigen::VectorXd weight = posterior.forest->posterior_weights(here);
  const auto shares_of_classes = [&] {
    Eigen::RowVectorXd share = Eigen::RowVectorXd::Zero(samples.classes);
    for (Eigen::Index i = 0; i < weight.size(); ++i)
      share(samples.label[static_cast<std::size_t>(i)]) += weight(i);
    return share;
  };
  const Eigen::RowVectorXd likeness = shares_of_classes();
  const auto cases = static_cast<Eigen::Index>(set.cases.size());
  posterior.size_density.resize(cases);
  for (Eigen::Index i = 0; i < cases; ++i)
    posterior.size_density(i) =
        density_of_size(problem, set.cases[static_cast<std::size_t>(i)], observed.size_m(i), seen.size_m);
  weight.head(cases).array() *= posterior.size_density.array();
  weight.tail(weight.size() - cases) *= density_of_another_cause(problem, seen.size_m);
  Eigen::RowVectorXd share = shares_of_classes();
  // The recording resembles neither a case nor a vibration of another cause, so it counts as "none of these".
  if (share.sum() == 0) share(samples.classes - 1) = 1;
  posterior.sharpness =
      best_sharpness(posterior.forest->out_of_bag_probabilities(), samples.label, samples.weight);
  const auto probabilities = [&](double power) -> Eigen::RowVectorXd {
    Eigen::RowVectorXd all = sharpened(share / share.sum(), posterior.sharpness * power);
    for (std::size_t k = 0; k < problem.prior.size(); ++k) {
      const auto c = static_cast<Eigen::Index>(k);
      // A size that excludes a candidate does so however weak the evidence of the features is.
      if (share(c) == 0 && likeness(c) > 0) all(c) = std::pow(all(c), 1 / power);
      all(c) *= (1 - prior_of_none) * problem.prior[k];
    }
    all(samples.classes - 1) *= prior_of_none;
    return all / all.sum();
  };
  Eigen::RowVectorXd all = probabilities(1);
  // "None of these" says already that hardly any case resembles the recording.
  if (all(samples.classes - 1) < 0.5) all = probabilities(evidence_power);
  posterior.none = all(samples.classes - 1);
  posterior.probability = all.head(samples.classes - 1).transpose() / (1 - posterior.none);
  posterior.weight = weight.head(cases);
  for (Eigen::Index i = 0; i < posterior.weight.size(); ++i) {
    const int label = samples.label[static_cast<std::size_t>(i)];
    if (share(label) > 0)
      posterior.weight(i) = posterior.weight(i) / share(label) * posterior.probability(label);
  }
  return posterior;
}

double p_value_of(const ObservedCases& observed, const features::DescribedMotion& seen, int threads) {
  return forest::Novelty(observed.features, threads).p_value(features::values_of(seen.features));
}

double evidence_power_of(double p_value) {
  constexpr double usual = 0.2, least = 0.5;
  return least + (1 - least) * std::min(1.0, p_value / usual);
}

}  // namespace rubsweep::diagnose::inference
