#pragma once

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>
#include <vector>

#include "rubsweep/core/contact/contact_mode.hpp"
#include "rubsweep/core/contact/dry_friction.hpp"
#include "rubsweep/core/integrate/adaptive/step_method.hpp"
#include "rubsweep/core/integrate/law/settle_slips.hpp"
#include "rubsweep/core/numerics/polynomial_root.hpp"

namespace rubsweep::integrate::adaptive {

/// Finds the first event in an accepted step. States inside the step come from the method's dense output. A
/// guard is approximated by the quartic through its values and rates at both ends and its value in the
/// middle. All members belong to the calling run.
template <class Law>
struct CrossingSearch {
  Law& dynamics;
  RightHandSide& right_hand_side;  ///< the dynamics as an interface
  StepMethod& method;
  const Step& step;
  const std::vector<contact::Kinematics>&start_kinematics, &end_kinematics;
  const std::vector<int>& zeros;  ///< above 0: a slip that starts from zero and grows
  State &probe, &probe_rate;      ///< scratch for a state inside the step

  /// A step of a method that has searched it has no other change of a mode, and no other release.
  std::optional<Crossing> first() {
    std::optional<Crossing> earliest = step.ending;
    for (std::size_t i = 0; i < dynamics.system().contacts.size(); ++i) {
      const contact::Guards at_start = dynamics.guards(i, start_kinematics[i]);
      const contact::Guards at_end = dynamics.guards(i, end_kinematics[i]);
      for (int e = 0; e < at_start.count && !step.knows_modes; ++e) {
        const auto k = static_cast<std::size_t>(e);
        const auto value = [&](double phase) { return dynamics.guards(i, inside(i, phase)).list[k].value; };
        const auto phase = locate(at_start.list[k], at_end.list[k], value);
        if (phase && (!earliest || *phase < earliest->phase))
          earliest = Crossing{*phase, i, at_start.list[k].next};
      }
      const bool curved = dynamics.system().contacts[i].law && dynamics.modes()[i] != contact::Mode::open;
      if (curved && !step.knows_modes) [[unlikely]]
        locate_knots(i, earliest);
      const bool sticks = dynamics.slips()[i] == contact::Slip::sticking;
      if (!dynamics.touches_dry(i) || (sticks && step.knows_modes)) continue;
      const auto candidate = sticks ? locate_release(i) : locate_stop(i);
      if (candidate && (!earliest || candidate->phase < earliest->phase)) earliest = candidate;
    }
    return earliest;
  }

 private:
  /// Share of the height of a slip's interpolant. If the interpolant comes closer to zero, its maximum is
  /// refined.
  static constexpr double near_zero = 0.1;
  /// Largest rise between three points of a step that the points may miss, relative to their differences.
  static constexpr double most_unseen = 2;
  /// Most knots at which steps end; error estimates see the small bends of denser curves.
  static constexpr std::size_t most_knots = 64;
  static constexpr double shortest_share = 1e-12;  ///< shortest time to an event, as a share of the step

  /// Friction needed to hold a contact, and its limit.
  struct Friction {
    double holds_n = 0, largest_n = 0;
    /// Excess of the needed friction over the limit in the direction of `sign`.
    double over(double sign) const { return sign * holds_n - largest_n; }
  };

  /// Kinematics of contact `i` inside the step. No guard depends on the acceleration, here arbitrary.
  contact::Kinematics inside(std::size_t i, double phase) {
    method.state_at(right_hand_side, step, phase, probe);
    return dynamics.kinematics(i, probe, step.end_rate);
  }

  const State& state_inside(double phase) {
    if (phase <= step.start_phase) return step.start;
    if (phase >= step.end_phase) return step.end;
    method.state_at(right_hand_side, step, phase, probe);
    return probe;
  }

  /// Zero of the slip of contact `i`, which slips. If the slip starts at zero, the start is no event. The
  /// slip of a poised contact stops beyond the edge of its zero band instead.
  std::optional<Crossing> locate_stop(std::size_t i) {
    const double h = step.end_phase - step.start_phase;
    const double sign = -contact::sign_of(dynamics.slips()[i]);
    const auto slip = [&](double x) {
      return sign * dynamics.slip(i, state_inside(step.start_phase + x * h));
    };
    const double edge = dynamics.poised(i) ? std::max(0.0, slip(0) + poised_edge(i)) : 0;
    const auto value = [&](double x) { return slip(x) - edge; };
    const bool moved = zeros[i] > 0;
    const double at_start = moved ? 0 : value(0), at_end = value(1);
    const double rate = moved ? 0 : sign * h * dynamics.slip_rate(i, step.start, step.start_rate);
    const double end_rate = sign * h * dynamics.slip_rate(i, step.end, step.end_rate);
    if (!moved && numerics::clearly_below_zero(at_start, rate, at_end, end_rate)) return std::nullopt;
    const numerics::Quartic quartic = numerics::quartic_through(at_start, rate, value(0.5), at_end, end_rate);
    const auto rise = numerics::bernstein_root(quartic);
    auto phase = rise ? refine(value, *rise) : std::nullopt;
    if (!phase && at_end >= 0) phase = hidden_rise(value);
    const auto [low, high] = std::ranges::minmax(quartic);
    if (!phase && !moved && high > -near_zero * (high - low)) phase = shallow_rise(value);
    if (!phase) return std::nullopt;
    return Crossing{*phase, i, {}, Crossing::Event::stop, {}};
  }

  double poised_edge(std::size_t i) const {
    const auto& c = dynamics.system().contacts[i];
    return law::poised_slip * std::max(1.0, std::abs(c.surface_speed_m_per_s / c.slip_scale_m_per_s));
  }

  /// Rise through zero of a function that is >= 0 at the end of the step and negative at its start (or zero,
  /// for a slip that starts there). The rise may be earlier than all points of the interpolant.
  template <class Value>
  std::optional<double> hidden_rise(const Value& value) {
    double x = 1;
    while (x > shortest_share) {
      x /= 2;
      if (value(x) < 0) return rise_between(value, x, 2 * x);
    }
    return step.start_phase + x * (step.end_phase - step.start_phase);
  }

  /// First zero of a function that is negative at the start of the step, searched near its largest value. A
  /// slip that barely reaches zero does stop, which changes the motion, in contrast to a shallow graze.
  template <class Value>
  std::optional<double> shallow_rise(const Value& value) {
    constexpr int places = 16;
    int best = 1;
    double largest = value(1.0 / places);
    for (int k = 2; k <= places; ++k) {
      const double here = value(static_cast<double>(k) / places);
      if (here > largest) largest = here, best = k;
    }
    std::uintmax_t iterations = 60;
    const auto top = boost::math::tools::brent_find_minima(
        [&](double x) { return -value(x); }, static_cast<double>(best - 1) / places,
        std::min(1.0, static_cast<double>(best + 1) / places), std::numeric_limits<double>::digits / 2,
        iterations);
    return top.second <= 0 ? rise_between(value, 0, top.first) : std::nullopt;
  }

  /// Release of contact `i`, which sticks: the needed friction exceeds the limit. The derivative of this
  /// friction is unknown, so it is approximated by a parabola through three points.
  std::optional<Crossing> locate_release(std::size_t i) {
    const double h = step.end_phase - step.start_phase;
    const auto friction_at = [&](double x) {
      const double phase = step.start_phase + x * h;
      const State& state = state_inside(phase);
      dynamics.loose(state, probe_rate, phase);
      return Friction{dynamics.hold(state, probe_rate).force_n(i), dynamics.largest_friction_n(i, state)};
    };
    const Friction first = friction_at(0), middle = friction_at(0.5), last = friction_at(1);
    std::optional<Crossing> earliest;
    for (const contact::Slip slip : {contact::Slip::forward, contact::Slip::backward}) {
      const double sign = contact::sign_of(slip);
      const double a = first.over(sign), b = middle.over(sign), c = last.over(sign);
      const auto rise =
          numerics::bernstein_root(numerics::quartic_through(a, 4 * b - 3 * a - c, b, c, a - 4 * b + 3 * c));
      const auto value = [&](double x) { return friction_at(x).over(sign); };
      auto phase = rise ? refine(value, *rise) : std::nullopt;
      if (!phase && c > 0) phase = hidden_rise(value);
      const auto [low, high] = std::minmax({a, b, c});
      // Where friction drops at the release, even a short excess counts.
      if (!phase && a < 0 && dynamics.holds_harder(i) && high > -most_unseen * (high - low))
        phase = shallow_rise(value);
      constexpr double never = std::numeric_limits<double>::infinity();
      const double at = phase.value_or(never);
      if (at < (earliest ? earliest->phase : never))
        earliest = Crossing{at, i, {}, Crossing::Event::release, slip};
    }
    return earliest;
  }

  /// Makes the first passage of contact `i` over a knot of its force the `earliest` event. It can only be a
  /// knot beside the start. A penetration at a knot has passed it if it moves away.
  void locate_knots(std::size_t i, std::optional<Crossing>& earliest) {
    const auto& c = dynamics.system().contacts[i];
    const auto& knots_m = c.law->knots_m();
    if (knots_m.size() > most_knots) return;
    const contact::Kinematics &start = start_kinematics[i], &end = end_kinematics[i];
    const auto scaled = [&](double knot_m) { return knot_m / c.length_m; };
    const auto above = start.closing_speed > 0
                           ? std::ranges::upper_bound(knots_m, start.penetration, {}, scaled)
                           : std::ranges::lower_bound(knots_m, start.penetration, {}, scaled);
    const auto look = [&](double knot, double way) {
      const auto guard = [&](const contact::Kinematics& k) {
        return contact::Guard{way * (k.penetration - knot), way * k.closing_speed};
      };
      const auto phase =
          locate(guard(start), guard(end), [&](double at) { return guard(inside(i, at)).value; });
      if (phase && (!earliest || *phase < earliest->phase))
        earliest = Crossing{*phase, i, {}, Crossing::Event::knot, {}};
    };
    if (above != knots_m.end()) look(scaled(*above), 1);
    if (above != knots_m.begin()) look(scaled(*std::prev(above)), -1);
  }

  /// Phase at which a guard rises through zero. `value_at`: its value by the phase.
  template <class Value>
  std::optional<double> locate(const contact::Guard& at_start, const contact::Guard& at_end,
                               const Value& value_at) {
    const double h = step.end_phase - step.start_phase;
    if (numerics::clearly_below_zero(at_start.value, h * at_start.rate, at_end.value, h * at_end.rate))
      return std::nullopt;
    const double middle = value_at(step.start_phase + h / 2);
    const auto rise = numerics::bernstein_root(
        numerics::quartic_through(at_start.value, h * at_start.rate, middle, at_end.value, h * at_end.rate));
    const auto value = [&](double x) { return value_at(step.start_phase + x * h); };
    auto phase = rise ? refine(value, *rise) : std::nullopt;
    // Excludes a return from a graze. A guard that starts at zero may rise by any of its derivatives.
    if (!phase && at_end.value >= 0 && (at_start.value <= 0 || at_start.rate >= 0))
      phase = hidden_rise(value);
    return phase;
  }

  /// Root of the true guard function `value` near the root of its interpolant, both in units of the step.
  /// Empty when the function does not change sign: the graze is then shallower than the interpolation error
  /// and invisible at any tolerance.
  template <class Value>
  std::optional<double> refine(const Value& value, double rise) {
    for (double reach = 1e-7; reach < 30; reach *= 30) {
      const double low = std::max(0.0, rise - reach), high = std::min(1.0, rise + reach);
      const double at_low = value(low), at_high = value(high);
      if (at_low < 0 && at_high >= 0) return rise_between(value, low, high);
    }
    return std::nullopt;
  }

  /// Root between `low` and `high`, both in units of the step; empty unless the function rises between them.
  template <class Value>
  std::optional<double> rise_between(const Value& value, double low, double high) {
    const double h = step.end_phase - step.start_phase;
    const double at_low = value(low), at_high = value(high);
    if (!(at_low < 0 && at_high >= 0)) return std::nullopt;
    if (at_high == 0) return step.start_phase + high * h;
    std::uintmax_t iterations = 400;  // four of them at least halve the bracket (Alefeld, Potra & Shi)
    const auto close_enough = [](double a, double b) { return std::abs(b - a) < 1e-15; };
    const auto bracket =
        boost::math::tools::toms748_solve(value, low, high, at_low, at_high, close_enough, iterations);
    // the upper end of the bracket, where the value is at or beyond zero
    return step.start_phase + bracket.second * h;
  }
};

}  // namespace rubsweep::integrate::adaptive
