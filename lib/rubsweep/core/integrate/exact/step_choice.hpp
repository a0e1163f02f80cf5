#pragma once

#include <algorithm>

#include "rubsweep/core/integrate/exact/exact_motion.hpp"
#include "rubsweep/core/numerics/certified_step.hpp"

namespace rubsweep::integrate::exact {

/// Limits on the choice of a step.
struct StepLimits {
  double until_s = 0;                ///< largest step
  double reach_s = 0;                ///< longest landing
  double shortest_to_annular_s = 0;  ///< a shorter step towards an annular stop counts as touching it
  double same_instant_s = 0;         ///< crossings closer than this count as simultaneous
};

/// Next action of an exact run: a step that crosses no guard, or a landing on the first guard that is
/// crossed.
struct StepChoice {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  double step_s = 0;            ///< certified step, or the latest instant of the crossing
  std::size_t crossing = none;  ///< index of the guard that certainly crosses first
  double earliest_s = 0;        ///< earliest possible instant of the crossing
  bool annular = false;         ///< true: an annular stop is about to be touched

  /// Limits the step. If the limit is before the latest instant of the chosen crossing, this crossing is no
  /// longer certain to be the first. The step then ends before the crossing as well, unless all of this
  /// counts as one instant.
  void keep_below(double other_step_s, double same_instant_s) {
    if (other_step_s >= step_s) return;
    const double safe_s = crossing == none ? other_step_s : std::min(other_step_s, earliest_s);
    if (crossing != none && step_s - safe_s <= same_instant_s) return;
    step_s = safe_s;
    crossing = none;
  }

  /// Adds a crossing of guard `e` between two instants; the later one is within reach. Of two crossings, one
  /// is certainly the first if its latest instant is before the earliest instant of the other. If neither is,
  /// the step ends before both: seen from there, both intervals are smaller, by the square of their length.
  void keep_first(std::size_t e, double from_s, double to_s, double same_instant_s) {
    if (crossing == none) {
      if (to_s >= step_s) return keep_below(from_s, same_instant_s);
      *this = {to_s, e, from_s, annular};
    } else if (from_s < step_s) {
      const double both_s = std::min(earliest_s, from_s);
      const bool first = to_s <= earliest_s, at_once = std::max(to_s, step_s) - both_s <= same_instant_s;
      if (!first && !at_once) return keep_below(both_s, same_instant_s);
      if (to_s < step_s) *this = {to_s, e, from_s, annular};
      if (at_once) earliest_s = both_s;
    }
  }
};

/// Narrows the choice by `linear`, which is guard `e` of the mode.
template <int N>
void limit_by_guard(const ExactMotion<N>& motion, const modes::LinearGuard<N>& linear, std::size_t e,
                    const StepLimits& limits, StepChoice& choice) {
  const auto limit = [&](const typename ExactMotion<N>::GuardValue& guard, double slow_step) {
    if (numerics::stays_below(guard.value, guard.rate, guard.curvature, choice.step_s)) return;
    const double safe = std::max(slow_step, numerics::safe_step(guard.value, guard.rate, guard.curvature));
    if (numerics::crosses(guard.value, guard.rate, guard.curvature)) {
      const double latest = numerics::latest_crossing(guard.value, guard.rate, guard.curvature);
      if (latest <= limits.reach_s) return choice.keep_first(e, safe, latest, limits.same_instant_s);
    }
    choice.keep_below(safe, limits.same_instant_s);
  };
  const auto forced = motion.forced_guard(e);
  if (linear.terms.slow_count == 0)
    return limit(motion.whole_guard(linear, motion.fast_sum(linear), forced), 0);
  const modes::ModalSum slow_terms = motion.slow_sum(linear);
  const auto slow = motion.slow_guard(linear, slow_terms, forced);
  if (numerics::stays_below(slow.value, slow.rate, slow.curvature, choice.step_s)) return;
  const double slow_step = slow.value < 0 ? numerics::safe_step(slow.value, slow.rate, slow.curvature) : 0;
  // There is no crossing within reach.
  if (slow_step > limits.reach_s) return choice.keep_below(slow_step, limits.same_instant_s);
  limit(motion.whole_guard(linear, motion.with_fast(linear, slow_terms), forced), slow_step);
}

/// Narrows the choice by annular stop `r`.
template <int N>
void limit_by_annular_guard(const ExactMotion<N>& motion, std::size_t r,
                            const typename ExactMotion<N>::State& sizes, const StepLimits& limits,
                            StepChoice& choice) {
  const auto guard = motion.annular(r, sizes);
  const double step = numerics::safe_step(guard.value, guard.rate, guard.curvature);
  const bool near = numerics::crosses(guard.value, guard.rate, guard.curvature);
  if (guard.value >= 0 || (near && step < choice.step_s) || step < limits.shortest_to_annular_s)
    choice.annular = true;
  choice.keep_below(step, limits.same_instant_s);
}

/// The longest certified step of the motion.
template <int N>
StepChoice choose_step(const ExactMotion<N>& motion, const StepLimits& limits) {
  const modes::LinearMode<N>& mode = motion.mode();
  StepChoice choice{.step_s = std::min(mode.longest_step_s, limits.until_s)};
  std::size_t e = 0;
  for (const modes::LinearGuard<N>& linear : mode.guards) limit_by_guard(motion, linear, e++, limits, choice);
  if (mode.annular_guards.empty()) return choice;
  const auto sizes = motion.sizes();
  for (std::size_t r = 0; r < mode.annular_guards.size(); ++r)
    limit_by_annular_guard(motion, r, sizes, limits, choice);
  return choice;
}

}  // namespace rubsweep::integrate::exact
