#include "rubsweep/sweep/basin_sampling.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "rubsweep/basin/low_discrepancy.hpp"

namespace rubsweep::sweep {

std::vector<KeyValue> draw(const BasinSampling& sampling, std::size_t index) {
  const std::vector<double> point = basin::low_discrepancy_point(index, sampling.over.size());
  std::vector<KeyValue> keys;
  for (std::size_t i = 0; i < point.size(); ++i) {
    const DrawnKey& drawn = sampling.over[i];
    const auto [low, high] = std::minmax(drawn.from, drawn.to);
    const double value = drawn.logarithmic
                             ? std::exp(std::lerp(std::log(drawn.from), std::log(drawn.to), point[i]))
                             : std::lerp(drawn.from, drawn.to, point[i]);
    keys.push_back({drawn.key, std::clamp(value, low, high)});
  }
  return keys;
}

Basins sample_basins(const BasinSampling& sampling,
                     const std::function<SampledMotion(const std::vector<KeyValue>&)>& run) {
  std::vector<SampledMotion> motions;
  for (std::size_t i = 0; i < sampling.samples; ++i) motions.push_back(run(draw(sampling, i)));
  return tell_apart(std::move(motions));
}

}  // namespace rubsweep::sweep
