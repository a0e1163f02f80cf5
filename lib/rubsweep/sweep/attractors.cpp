#include "rubsweep/sweep/attractors.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "rubsweep/basin/fraction.hpp"

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

/// The number of the attractor, from 1 in the order in which they are met.
int number_of(SampledMotion&& motion, Basins& basins) {
  if (motion.failed) {
    ++basins.failed;
    return 0;
  }
  auto known = std::ranges::find_if(
      basins.attractors, [&](const Attractor& attractor) { return alike(attractor.motion, motion); });
  if (known == basins.attractors.end()) known = basins.attractors.insert(known, Attractor{std::move(motion)});
  ++known->samples;
  return static_cast<int>(known - basins.attractors.begin()) + 1;
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

Basins tell_apart(std::vector<SampledMotion> motions) {
  Basins basins;
  for (SampledMotion& motion : motions) basins.numbers.push_back(number_of(std::move(motion), basins));
  for (Attractor& attractor : basins.attractors) {
    attractor.share = basin::fraction(attractor.samples, motions.size());
    attractor.standard_error = basin::standard_error(attractor.share, motions.size());
  }
  sort_by_frequency(basins);
  return basins;
}

}  // namespace rubsweep::sweep
