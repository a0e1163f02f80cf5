#include "rubsweep/maps/sweep/basin_sampling.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "rubsweep/maps/basin/low_discrepancy.hpp"

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

void sort_by_frequency(Basins& basins) {
  std::vector<std::size_t> order(basins.attractors.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, std::greater<>(),
                           [&](std::size_t i) { return basins.attractors[i].samples; });
  std::vector<int> new_number(order.size() + 1, 0);
  std::vector<Attractor> sorted;
  for (const std::size_t i : order) {
    sorted.push_back(std::move(basins.attractors[i]));
    new_number[i + 1] = static_cast<int>(sorted.size());
  }
  basins.attractors = std::move(sorted);
  for (int& number : basins.numbers) number = new_number[static_cast<std::size_t>(number)];
}

}  // namespace

void AttractorCount::add(SampledMotion motion) {
  if (motion.failed) {
    ++met_.failed;
    met_.numbers.push_back(0);
    return;
  }
  auto known = std::ranges::find_if(
      met_.attractors, [&](const Attractor& attractor) { return alike(attractor.motion, motion); });
  if (known == met_.attractors.end())
    known = met_.attractors.insert(known, Attractor{.motion = std::move(motion)});
  ++known->samples;
  met_.numbers.push_back(static_cast<int>(known - met_.attractors.begin()) + 1);
}

Basins AttractorCount::basins() const {
  Basins basins = met_;
  for (Attractor& attractor : basins.attractors) {
    attractor.share = basin::fraction(attractor.samples, basins.numbers.size());
    attractor.standard_error = basin::standard_error(attractor.share, basins.numbers.size());
  }
  sort_by_frequency(basins);
  return basins;
}

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
