#pragma once

#include <cmath>
#include <cstdint>

#include "rubsweep/measurement/diagnose/forest/forest.hpp"

namespace rubsweep::diagnose::forest {

/// Two normal distributions with unit deviation, whose means differ by 2 in the first feature; the second
/// feature has no information.
inline LabelledSamples two_clouds(int count, std::uint64_t seed) {
  LabelledSamples samples{Eigen::MatrixXd(count, 2), {}, Eigen::VectorXd::Ones(count), 2};
  RandomStream random(seed, 0, 0);
  for (int i = 0; i < count; ++i) {
    samples.label.push_back(i % 2);
    samples.features(i, 0) = (i % 2 == 0 ? -1 : 1) + random.normal();
    samples.features(i, 1) = random.normal();
  }
  return samples;
}

/// Two clouds that overlap in both features; only the difference of the features separates them, by 1.
inline LabelledSamples slanting_clouds(int count, std::uint64_t seed) {
  LabelledSamples samples = two_clouds(count, seed);
  for (int i = 0; i < count; ++i) {
    const double common = 3 * samples.features(i, 1);
    samples.features.row(i) << common + samples.label[static_cast<std::size_t>(i)], common;
  }
  return samples;
}

/// Probability of the second cloud by Bayes' theorem; its prior weight is `odds` times that of the first.
inline double second_cloud(double x, double odds = 1) { return 1 / (1 + std::exp(-2 * x) / odds); }

}  // namespace rubsweep::diagnose::forest
