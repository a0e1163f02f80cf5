#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "rubsweep/core/integrate/taylor/expansion.hpp"

namespace rubsweep::integrate::taylor {

/// Duration up to which the change by the latest sweep of `creep` is at most `smallest`; zero where it is
/// larger from the start.
inline double unchanged_rad(const Creep& creep, int order, double smallest) {
  if (std::abs(creep.change(0)) > smallest) return 0;
  double longest = std::numeric_limits<double>::infinity();
  for (int k = 1; k < order; ++k) {
    const double change = std::abs(creep.change(k));
    if (change * std::pow(std::min(longest, 1.0), k) > smallest)
      longest = std::min(longest, std::pow(smallest / change, 1.0 / k));
  }
  return longest;
}

/// Expands a motion by `expand(state)`, with the creeping contacts set by `Expansion::set_creeping`, until
/// sweeps change only the rounding. What remains of the transient in the slips of `state` is removed if this
/// changes the slips only by rounding. Returns the duration over which the result is accurate, at most
/// `longest_rad`. Returns zero, with `state` unchanged, where this is less than `worth_rad`. `settled` is
/// scratch for a state.
template <int N, class Expand>
double settle_creep(Expansion<N>& motion, const Expand& expand, std::vector<double>& state,
                    std::vector<double>& settled, double longest_rad, double worth_rad) {
  constexpr double rounding = 1e-16, start_noise = 1e-13;
  settled = state;
  double moved = 0, reach = 0;
  for (int sweep = 0; sweep < most_creep_sweeps; ++sweep) {
    expand(settled);
    const double speed = std::max(1.0, motion.series().speed());
    const double wanted = motion.series().converged_rad(longest_rad);
    if (!(wanted >= worth_rad)) return 0;
    reach = wanted;
    double change = 0;
    contact::StickVector by(static_cast<Eigen::Index>(motion.sticking()));
    for (Eigen::Index j = 0; j < by.size(); ++j) {
      const std::size_t i = motion.stuck(j);
      by(j) = 0;
      if (!motion.contact(i).creep()) continue;
      Creep& creep = motion.creep(i);
      if (!creep.sweep(motion.contact(i), motion.order())) return 0;
      by(j) = (creep.slip_m_per_s() - motion.slip(i)) / motion.law(i).slip_scale_m_per_s;
      change = std::max(change, std::abs(creep.change(0)));
      reach = std::min(reach, unchanged_rad(creep, motion.order(), rounding * speed));
    }
    if (reach >= wanted) break;
    motion.change_slips(by, settled.data());
    moved = 0;
    for (std::size_t k = state.size() / 2; k < state.size(); ++k)
      moved = std::max(moved, std::abs(settled[k] - state[k]));
    // By now the remaining transient of the slip is known, and it is too large.
    if (moved > start_noise * speed && change < 0.1 * moved) return 0;
  }
  if (moved > start_noise * std::max(1.0, motion.series().speed()) || reach < worth_rad) return 0;
  motion.series().put_state(0, state.data());
  return reach;
}

}  // namespace rubsweep::integrate::taylor
