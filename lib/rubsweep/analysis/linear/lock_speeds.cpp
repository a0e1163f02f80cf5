#include "rubsweep/analysis/linear/lock_speeds.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "rubsweep/core/numerics/pchip.hpp"

namespace rubsweep::linear {
namespace {

constexpr std::size_t most_modes = 4;
constexpr std::array<std::pair<int, int>, 3> orders{{{2, 1}, {3, 1}, {3, 2}}};
constexpr int halvings = 60;
/// a mode with more damping has decayed before both modes meet the wall again
constexpr double most_damping_ratio = 0.5;

double signed_hz(const CampbellPoint& point) {
  return point.forward_share >= 0.5 ? point.frequency_hz : -point.frequency_hz;
}

bool lasts_somewhere(const CampbellMode& mode) {
  return std::ranges::any_of(
      mode.points, [](const CampbellPoint& point) { return point.damping_ratio <= most_damping_ratio; });
}

/// Mode as a function of the speed.
struct Branch {
  int number = 0;
  std::vector<double> speed_hz;
  std::vector<double> damping_ratio;
  numerics::Pchip signed_hz;

  bool lasts_at(std::size_t k) const { return damping_ratio[k] <= most_damping_ratio; }
  /// Whether the mode is lightly damped and keeps its sense of whirl over the interval that ends at point k.
  bool lasts_up_to(std::size_t k) const {
    return lasts_at(k - 1) && lasts_at(k) && signed_hz(speed_hz[k - 1]) * signed_hz(speed_hz[k]) > 0;
  }
};

Branch branch_of(const CampbellMode& mode) {
  std::vector<double> speeds, frequencies, ratios;
  for (const CampbellPoint& point : mode.points) {
    speeds.push_back(point.speed_hz);
    frequencies.push_back(signed_hz(point));
    ratios.push_back(point.damping_ratio);
  }
  return {mode.number, speeds, ratios, numerics::Pchip(speeds, frequencies)};
}

/// Index of a speed in a branch; empty where the mode does not whirl at this speed.
std::optional<std::size_t> place_of(const Branch& branch, double speed_hz) {
  const auto found = std::ranges::lower_bound(branch.speed_hz, speed_hz);
  if (found == branch.speed_hz.end() || *found != speed_hz) return std::nullopt;
  return static_cast<std::size_t>(found - branch.speed_hz.begin());
}

/// Adds the speeds at which two modes lock: at most one root in each interval of the diagram with both modes.
void add_roots(const Branch& first, const Branch& second, int p, int q, std::vector<LockSpeed>& found) {
  const auto excess = [&](double hz) {
    return (p - q) * hz - p * first.signed_hz(hz) + q * second.signed_hz(hz);
  };
  for (std::size_t k = 0; k < first.speed_hz.size(); ++k) {
    const double end = first.speed_hz[k];
    const auto place = place_of(second, end);
    if (!place || !first.lasts_at(k) || !second.lasts_at(*place)) continue;
    if (excess(end) == 0 && end > 0) found.push_back({first.number, second.number, p, q, end});
    if (k == 0 || *place == 0 || second.speed_hz[*place - 1] != first.speed_hz[k - 1]) continue;
    if (!first.lasts_up_to(k) || !second.lasts_up_to(*place)) continue;
    if (!(excess(first.speed_hz[k - 1]) * excess(end) < 0)) continue;
    double low = first.speed_hz[k - 1], high = end;
    for (int i = 0; i < halvings; ++i) {
      const double middle = low + (high - low) / 2;
      (excess(middle) * excess(end) < 0 ? low : high) = middle;
    }
    found.push_back({first.number, second.number, p, q, high});
  }
}

}  // namespace

std::vector<LockSpeed> lock_speeds(const Campbell& diagram) {
  std::vector<Branch> branches;
  for (const CampbellMode& mode : diagram.modes)
    if (branches.size() < most_modes && lasts_somewhere(mode)) branches.push_back(branch_of(mode));
  std::vector<LockSpeed> found;
  for (const Branch& first : branches) {
    for (const Branch& second : branches) {
      if (first.number == second.number) continue;
      for (const auto& [p, q] : orders) add_roots(first, second, p, q, found);
    }
  }
  std::ranges::stable_sort(found, {}, &LockSpeed::speed_hz);
  return found;
}

}  // namespace rubsweep::linear
