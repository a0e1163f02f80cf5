#pragma once

#include <algorithm>

#include "rubsweep/integrate/certified_step.hpp"
#include "rubsweep/integrate/exact_motion.hpp"

namespace rubsweep::integrate {

/// What an exact run may do next: a step that no exit is crossed in, or a landing on the first one crossed.
struct StepChoice {
  static constexpr std::size_t none = static_cast<std::size_t>(-1);

  double step_s = 0;            ///< safe, or the latest instant of the crossing
  std::size_t crossing = none;  ///< this exit is crossed, for certain and first
  bool ring = false;            ///< a ring is about to be touched

  void keep_below(double other_step_s) {
    if (other_step_s >= step_s) return;
    step_s = other_step_s;
    crossing = none;
  }
};

/// Narrows the choice by exit `e`, whose plan is given; `reach_s` is the longest landing.
template <int N>
void heed_exit(const ExactMotion<N>& motion, const ExitPlan<N>& plan, std::size_t e, double reach_s,
               StepChoice& choice) {
  const auto heed = [&](const typename ExactMotion<N>::Exit& exit, double slow_step) {
    if (stays_below(exit.value, exit.rate, exit.curvature, choice.step_s)) return;
    if (crosses(exit.value, exit.rate, exit.curvature)) {
      const double latest = latest_crossing(exit.value, exit.rate, exit.curvature);
      if (latest < choice.step_s && latest <= reach_s) {
        choice.step_s = latest;
        choice.crossing = e;
        return;
      }
    }
    choice.keep_below(std::max(slow_step, safe_step(exit.value, exit.rate, exit.curvature)));
  };
  const auto forced = motion.forced_exit(e);
  if (plan.seen.slow_count == 0) return heed(motion.whole_exit(plan, motion.fast_sum(plan), forced), 0);
  const SeenSum seen = motion.slow_sum(plan);
  const auto slow = motion.slow_exit(plan, seen, forced);
  if (stays_below(slow.value, slow.rate, slow.curvature, choice.step_s)) return;
  const double slow_step = slow.value < 0 ? safe_step(slow.value, slow.rate, slow.curvature) : 0;
  // No crossing within reach.
  if (slow_step > reach_s) return choice.keep_below(slow_step);
  heed(motion.whole_exit(plan, motion.with_fast(plan, seen), forced), slow_step);
}

/// Narrows the choice by ring `r`: steps shorter than `shortest_s` count as touching it.
template <int N>
void heed_ring(const ExactMotion<N>& motion, std::size_t r, const typename ExactMotion<N>::State& sizes,
               double shortest_s, StepChoice& choice) {
  const auto ring = motion.ring(r, sizes);
  const double step = safe_step(ring.value, ring.rate, ring.curvature);
  const bool near = crosses(ring.value, ring.rate, ring.curvature);
  if (ring.value >= 0 || (near && step < choice.step_s) || step < shortest_s) choice.ring = true;
  choice.step_s = std::min(choice.step_s, step);
}

/// The longest step of the motion that is certified, at most `until_s`.
template <int N>
StepChoice choose_step(const ExactMotion<N>& motion, double until_s, double reach_s,
                       double shortest_to_ring_s) {
  const ModePlan<N>& mode = motion.mode();
  StepChoice choice{.step_s = std::min(mode.longest_step_s, until_s)};
  std::size_t e = 0;
  for (const ExitPlan<N>& plan : mode.exits) heed_exit(motion, plan, e++, reach_s, choice);
  if (mode.rings.empty()) return choice;
  const auto sizes = motion.sizes();
  for (std::size_t r = 0; r < mode.rings.size(); ++r) heed_ring(motion, r, sizes, shortest_to_ring_s, choice);
  return choice;
}

}  // namespace rubsweep::integrate
