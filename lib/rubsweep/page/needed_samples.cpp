#include "rubsweep/page/needed_samples.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace rubsweep::page {
namespace {

struct Miss {
  std::size_t place = 0;
  double distance = 0;
};

/// The sample between `first` and `last` that the straight line between them misses most.
Miss largest_miss(std::span<const std::vector<double>> signals, std::size_t first, std::size_t last) {
  Miss worst;
  for (std::size_t k = first + 1; k < last; ++k) {
    const double share = static_cast<double>(k - first) / static_cast<double>(last - first);
    for (const std::vector<double>& signal : signals) {
      const double line = signal[first] + share * (signal[last] - signal[first]);
      const double distance = std::abs(signal[k] - line);
      if (distance > worst.distance) worst = {k, distance};
    }
  }
  return worst;
}

}  // namespace

std::vector<std::size_t> needed_samples(std::span<const std::vector<double>> signals, double tolerance,
                                        std::span<const std::size_t> always) {
  const std::size_t end = signals.front().size() - 1;
  std::vector<std::size_t> places{0};
  for (const std::size_t place : always)
    if (place > places.back() && place < end) places.push_back(place);
  places.push_back(end);

  std::vector<std::pair<std::size_t, std::size_t>> waiting;
  for (std::size_t i = 1; i < places.size(); ++i) waiting.emplace_back(places[i - 1], places[i]);
  while (!waiting.empty()) {
    const auto [first, last] = waiting.back();
    waiting.pop_back();
    const Miss miss = largest_miss(signals, first, last);
    if (miss.distance <= tolerance) continue;
    places.push_back(miss.place);
    waiting.emplace_back(first, miss.place);
    waiting.emplace_back(miss.place, last);
  }
  std::sort(places.begin(), places.end());
  return places;
}

}  // namespace rubsweep::page
