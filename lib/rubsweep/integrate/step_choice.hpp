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

  /// No further than this; a crossing that may come later is no longer certain to be the first.
  void keep_below(double other_step_s) {
    if (other_step_s >= step_s) return;
    step_s = other_step_s;
    crossing = none;
  }

  /// Exit `e` is crossed between these instants, the later one within reach. Of two crossings the first is
  /// the one whose latest instant comes before the other's earliest. Where that tells nothing the step ends
  /// before either: from there both intervals are smaller, by the square of their length.
  void keep_first(std::size_t e, double crossing_from_s, double crossing_to_s, double same_instant_s) {
    const double both_s = std::min(earliest_s, crossing_from_s);
    if (crossing == none ? crossing_to_s < step_s : crossing_to_s <= earliest_s) {
      *this = {crossing_to_s, e, crossing_from_s, ring};
    } else if (crossing == none) {
      keep_below(crossing_from_s);
    } else if (crossing_from_s < step_s) {
      if (std::max(crossing_to_s, step_s) - both_s > same_instant_s) return keep_below(both_s);
      if (crossing_to_s < step_s) *this = {crossing_to_s, e, both_s, ring};
      earliest_s = both_s;
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
    choice.keep_below(safe);
  };
  const auto forced = motion.forced_exit(e);
  if (plan.seen.slow_count == 0) return heed(motion.whole_exit(plan, motion.fast_sum(plan), forced), 0);
  const SeenSum seen = motion.slow_sum(plan);
  const auto slow = motion.slow_exit(plan, seen, forced);
  if (stays_below(slow.value, slow.rate, slow.curvature, choice.step_s)) return;
  const double slow_step = slow.value < 0 ? safe_step(slow.value, slow.rate, slow.curvature) : 0;
  // No crossing within reach.
  if (slow_step > limits.reach_s) return choice.keep_below(slow_step);
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
  choice.keep_below(step);
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
