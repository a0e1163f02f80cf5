#pragma once

#include <algorithm>

#include "rubsweep/integrate/certified_step.hpp"
#include "rubsweep/integrate/exact_motion.hpp"

namespace rubsweep::integrate {

/// What the choice of a step goes by.
struct StepLimits {
  double until_s = 0;             ///< no step is longer
  double reach_s = 0;             ///< longest landing
  double shortest_to_ring_s = 0;  ///< a shorter step towards a ring counts as touching it
  double same_instant_s = 0;      ///< crossings nearer to each other happen at one instant
};

/// What an exact run may do next: a step that no exit is crossed in, or a landing on the first one crossed.
struct StepChoice {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  double step_s = 0;            ///< safe, or the latest instant of the crossing
  std::size_t crossing = none;  ///< this exit is crossed, for certain and first
  double earliest_s = 0;        ///< before that it cannot be
  bool ring = false;            ///< a ring is about to be touched

  /// No further than this. A crossing that was to be landed on later than that is no longer certain to be the
  /// first: the step ends before it, too, unless all of this is one instant.
  void keep_below(double other_step_s, double same_instant_s) {
    if (other_step_s >= step_s) return;
    const double safe_s = crossing == none ? other_step_s : std::min(other_step_s, earliest_s);
    if (crossing != none && step_s - safe_s <= same_instant_s) return;
    step_s = safe_s;
    crossing = none;
  }

  /// Exit `e` is crossed between these instants, the later one within reach. Of two crossings the first is
  /// the one whose latest instant comes before the other's earliest. Where that tells nothing the step ends
  /// before either: from there both intervals are smaller, by the square of their length.
  void keep_first(std::size_t e, double from_s, double to_s, double same_instant_s) {
    if (crossing == none) {
      if (to_s >= step_s) return keep_below(from_s, same_instant_s);
      *this = {to_s, e, from_s, ring};
    } else if (from_s < step_s) {
      const double both_s = std::min(earliest_s, from_s);
      const bool first = to_s <= earliest_s, at_once = std::max(to_s, step_s) - both_s <= same_instant_s;
      if (!first && !at_once) return keep_below(both_s, same_instant_s);
      if (to_s < step_s) *this = {to_s, e, from_s, ring};
      if (at_once) earliest_s = both_s;
    }
  }
};

/// Narrows the choice by exit `e`, whose plan is given.
template <int N>
void heed_exit(const ExactMotion<N>& motion, const ExitPlan<N>& plan, std::size_t e, const StepLimits& limits,
               StepChoice& choice) {
  const auto heed = [&](const typename ExactMotion<N>::Exit& exit, double slow_step) {
    if (stays_below(exit.value, exit.rate, exit.curvature, choice.step_s)) return;
    const double safe = std::max(slow_step, safe_step(exit.value, exit.rate, exit.curvature));
    if (crosses(exit.value, exit.rate, exit.curvature)) {
      const double latest = latest_crossing(exit.value, exit.rate, exit.curvature);
      if (latest <= limits.reach_s) return choice.keep_first(e, safe, latest, limits.same_instant_s);
    }
    choice.keep_below(safe, limits.same_instant_s);
  };
  const auto forced = motion.forced_exit(e);
  if (plan.seen.slow_count == 0) return heed(motion.whole_exit(plan, motion.fast_sum(plan), forced), 0);
  const SeenSum seen = motion.slow_sum(plan);
  const auto slow = motion.slow_exit(plan, seen, forced);
  if (stays_below(slow.value, slow.rate, slow.curvature, choice.step_s)) return;
  const double slow_step = slow.value < 0 ? safe_step(slow.value, slow.rate, slow.curvature) : 0;
  // No crossing within reach.
  if (slow_step > limits.reach_s) return choice.keep_below(slow_step, limits.same_instant_s);
  heed(motion.whole_exit(plan, motion.with_fast(plan, seen), forced), slow_step);
}

/// Narrows the choice by ring `r`.
template <int N>
void heed_ring(const ExactMotion<N>& motion, std::size_t r, const typename ExactMotion<N>::State& sizes,
               const StepLimits& limits, StepChoice& choice) {
  const auto ring = motion.ring(r, sizes);
  const double step = safe_step(ring.value, ring.rate, ring.curvature);
  const bool near = crosses(ring.value, ring.rate, ring.curvature);
  if (ring.value >= 0 || (near && step < choice.step_s) || step < limits.shortest_to_ring_s)
    choice.ring = true;
  choice.keep_below(step, limits.same_instant_s);
}

/// The longest step of the motion that is certified.
template <int N>
StepChoice choose_step(const ExactMotion<N>& motion, const StepLimits& limits) {
  const ModePlan<N>& mode = motion.mode();
  StepChoice choice{.step_s = std::min(mode.longest_step_s, limits.until_s)};
  std::size_t e = 0;
  for (const ExitPlan<N>& plan : mode.exits) heed_exit(motion, plan, e++, limits, choice);
  if (mode.rings.empty()) return choice;
  const auto sizes = motion.sizes();
  for (std::size_t r = 0; r < mode.rings.size(); ++r) heed_ring(motion, r, sizes, limits, choice);
  return choice;
}

}  // namespace rubsweep::integrate
