#include "rubsweep/core/integrate/exact/tube/turn_tube.hpp"

#include <limits>

namespace rubsweep::integrate::exact::tube {
namespace {

// Length of windows in units of D / s, see the lemma. A tenth of D is reserved for the effect of the change's
// own deflection on the guard.
constexpr double window_in_distances = 4, share_of_distance = 0.9;
// The window is so short (Switch::longest_window_s) that the flow over it is the identity within 5 %.
constexpr double flow_over_window = 1.05, rate_over_window = 1.1, backwards_over_window = 1.2;
constexpr double largest_own_deflection = 0.2;

}  // namespace

double TurnTube::width(const Spread& spread, const Parts& radii, std::span<const Window> before) {
  double sum = radii.fast * spread.width.fast + radii.slow * spread.width.slow;
  for (std::size_t k = 0; k < before.size() && 2 * k + 1 < spread.deflections.size(); ++k)
    sum += before[k].deflection * (spread.deflections[2 * k] +
                                   rate_over_window * before[k].window_s * spread.deflections[2 * k + 1]);
  return sum;
}

std::optional<TurnTube::Window> TurnTube::window_of(const Switch& change, const Parts& radii,
                                                    std::span<const Window> before) {
  const auto wide = [&](const Spread& spread) { return width(spread, radii, before); };
  Window window;
  window.distance = wide(change.spread) / share_of_distance;
  window.window_s = window_in_distances * window.distance / change.rate;
  window.deflection = flow_over_window * window.distance * window.distance / change.rate;
  const double t = window.window_s;
  const double least_rate = change.rate - wide(change.rate_spread) -
                            (change.curvature + wide(change.curvature_spread)) * t -
                            change.own_deflection * window.distance;
  const bool rises = least_rate >= change.rate / 2 && change.lowest_rate >= change.rate / 4;
  if (!rises || change.own_deflection * t > largest_own_deflection || t > change.longest_window_s)
    return std::nullopt;
  for (const Other& other : change.others) {
    const double bend = backwards_over_window * (other.curvature + wide(other.curvature_spread)) * t * t / 2;
    const double value = other.value + wide(other.spread) + (other.rate + wide(other.rate_spread)) * t +
                         bend + flow_over_window * other.own_deflection * window.deflection;
    if (!(value < 0)) return std::nullopt;
  }
  return window;
}

std::optional<std::vector<TurnTube::Window>> TurnTube::windows(const Parts& radii) const {
  std::vector<Window> found;
  double free_from_s = 0;
  std::size_t next = 0;
  const auto margins_hold = [&](std::size_t end) {
    for (; next < end; ++next) {
      if (!(width(margins[next].spread, radii, found) < margins[next].margin)) return false;
    }
    return true;
  };
  for (const Switch& change : switches) {
    if (!margins_hold(change.margins_before)) return std::nullopt;
    const auto window = window_of(change, radii, found);
    if (!window || !(change.time_s - window->window_s > free_from_s)) return std::nullopt;
    free_from_s = change.time_s + window->window_s;
    found.push_back(*window);
  }
  if (!(free_from_s < period_s) || !margins_hold(margins.size())) return std::nullopt;
  return found;
}

bool TurnTube::holds(const Parts& radii) const { return windows(radii).has_value(); }

Parts TurnTube::deviation(const Parts& radii) const {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const auto at = windows(radii);
  if (!at) return {infinite, infinite};
  Parts sum;
  for (std::size_t k = 0; k < deflections.size(); ++k) {
    const Window& window = (*at)[k];
    const auto length = [&](double at_end, double rate_at_end) {
      return window.deflection * (at_end + rate_over_window * window.window_s * rate_at_end);
    };
    sum.fast += length(deflections[k].at_end.fast, deflections[k].rate_at_end.fast);
    sum.slow += length(deflections[k].at_end.slow, deflections[k].rate_at_end.slow);
  }
  return sum;
}

}  // namespace rubsweep::integrate::exact::tube
