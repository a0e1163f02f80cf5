#include "rubsweep/maps/sweep/threshold.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace rubsweep::sweep {
namespace {

using Probes = std::map<double, Probe>;

/// Middle of two numbers: their geometric mean if both are positive, else their arithmetic mean.
double between(double a, double b) { return a > 0 ? a * std::sqrt(b / a) : a + (b - a) / 2; }

/// Bisects between `a` and `b`, only one of which rubs, until the interval is within the tolerance. Adds
/// every number tried to `probes`.
void bisect(Probes& probes, double a, double b, double tolerance, double floor,
            const std::function<Probe(double)>& probe) {
  const bool before = probes.at(a).rubs;
  while (b - a > std::max(tolerance * std::max(std::abs(a), std::abs(b)), floor)) {
    const double middle = between(a, b);
    if (!(middle > a && middle < b)) return;
    const bool rubs = (probes[middle] = probe(middle)).rubs;
    (rubs == before ? a : b) = middle;
  }
}

std::vector<RubInterval> intervals_of(const Probes& probes) {
  std::vector<RubInterval> intervals;
  bool rubbed = false;
  for (const auto& [value, found] : probes) {
    if (found.rubs) {
      if (!rubbed) intervals.push_back({value, value, {}});
      RubInterval& interval = intervals.back();
      interval.to = value;
      if (std::ranges::find(interval.motions, found.motion) == interval.motions.end())
        interval.motions.push_back(found.motion);
    }
    rubbed = found.rubs;
  }
  return intervals;
}

}  // namespace

Threshold find_threshold(const ThresholdScan& scan, const std::function<Probe(double)>& probe) {
  Probes probes;
  const std::vector<double>& values = scan.axis.values;
  for (const double value : values) probes[value] = probe(value);
  const double floor = 1e-3 * scan.tolerance * (values.back() - values.front());
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (probes.at(values[i - 1]).rubs != probes.at(values[i]).rubs)
      bisect(probes, values[i - 1], values[i], scan.tolerance, floor, probe);
  }
  const auto failed = std::ranges::count_if(probes, [](const auto& tried) { return tried.second.failed; });
  return {intervals_of(probes), probes.size(), static_cast<std::size_t>(failed)};
}

}  // namespace rubsweep::sweep
