#include "rubsweep/sweep/basin_sampling.hpp"

#include <algorithm>
#include <cmath>

#include "rubsweep/basin/fraction.hpp"
#include "rubsweep/basin/low_discrepancy.hpp"

namespace rubsweep::sweep {
namespace {

constexpr double same_orbit = 1e-3;

bool alike(const SampledMotion& a, const SampledMotion& b) {
  if (a.name != b.name) return false;
  if (!a.repeats) return true;
  if (a.orbit_m.size() != b.orbit_m.size()) return false;
  double scale = 0;
  for (std::size_t i = 0; i < a.orbit_m.size(); ++i)
    scale = std::max({scale, std::abs(a.orbit_m[i]), std::abs(b.orbit_m[i])});
  for (std::size_t i = 0; i < a.orbit_m.size(); ++i) {
    if (std::abs(a.orbit_m[i] - b.orbit_m[i]) > same_orbit * scale) return false;
  }
  return true;
}

}  // namespace

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
  Basins basins;
  for (std::size_t i = 0; i < sampling.samples; ++i) {
    SampledMotion motion = run(draw(sampling, i));
    if (motion.failed) {
      ++basins.failed;
      continue;
    }
    const auto known = std::ranges::find_if(
        basins.attractors, [&](const Attractor& attractor) { return alike(attractor.motion, motion); });
    if (known != basins.attractors.end()) {
      ++known->samples;
    } else {
      basins.attractors.push_back({std::move(motion), 1});
    }
  }
  for (Attractor& attractor : basins.attractors) {
    attractor.share = basin::fraction(attractor.samples, sampling.samples);
    attractor.standard_error = basin::standard_error(attractor.share, sampling.samples);
  }
  std::ranges::stable_sort(basins.attractors, std::greater<>(), &Attractor::samples);
  return basins;
}

}  // namespace rubsweep::sweep
