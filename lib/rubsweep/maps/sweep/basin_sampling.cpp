#include "rubsweep/maps/sweep/basin_sampling.hpp"

#include <algorithm>
#include <cmath>

#include "rubsweep/maps/basin/low_discrepancy.hpp"

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
  AttractorCount count;
  for (std::size_t i = 0; i < sampling.samples; ++i) count.add(run(draw(sampling, i)));
  return count.basins();
}

}  // namespace rubsweep::sweep
