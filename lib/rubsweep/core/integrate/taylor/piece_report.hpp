#pragma once

#include <algorithm>
#include <vector>

#include "rubsweep/core/contact/contact_mode.hpp"
#include "rubsweep/core/integrate/run/scaled_system.hpp"
#include "rubsweep/core/integrate/run/turn.hpp"
#include "rubsweep/core/integrate/run/turn_book.hpp"
#include "rubsweep/core/integrate/taylor/contact_series.hpp"
#include "rubsweep/core/integrate/taylor/expansion.hpp"
#include "rubsweep/core/integrate/taylor/guard_search.hpp"
#include "rubsweep/core/numerics/full_turn.hpp"

namespace rubsweep::integrate::taylor {

/// Largest distances of points from their unloaded positions, scaled.
struct LargestDisplacements {
  double observed = 0;  ///< peak of the observed point
  double casing = 0;    ///< peak of any casing
};

inline constexpr int most_peak_states = 65;  ///< Largest number of states examined in a step, with its ends.

/// Peaks over the first `duration_rad` of an expanded motion. `fastest` is the fastest rate of the motion per
/// radian; `states` is scratch that grows to most_peak_states states.
template <int N>
LargestDisplacements largest_displacements(const Expansion<N>& motion, const run::ScaledSystem<N>& system,
                                           double fastest, double duration_rad, std::vector<double>& states);

/// Largest normal force of a touching contact over this duration, in newtons.
double largest_force(const ContactSeries& contact, int order, double fastest, double duration_rad);

/// Updates the peaks of `report` with both; `modes` per contact.
template <int N>
void note_peaks(const Expansion<N>& motion, const run::ScaledSystem<N>& system,
                const std::vector<contact::Mode>& modes, double fastest, double duration_rad,
                std::vector<double>& states, run::TurnReport& report) {
  for (std::size_t i = 0; i < modes.size(); ++i) {
    if (modes[i] == contact::Mode::open) continue;
    report.peak_contact_force_n = std::max(
        report.peak_contact_force_n, largest_force(motion.contact(i), motion.order(), fastest, duration_rad));
  }
  const auto [observed, casing] = largest_displacements(motion, system, fastest, duration_rad, states);
  const double length_m = system.scale.length_m;
  report.peak_displacement_m = std::max(report.peak_displacement_m, observed * length_m);
  report.peak_casing_displacement_m = std::max(report.peak_casing_displacement_m, casing * length_m);
}

/// Writes the samples due before `end_phase`, out of `wanted` evenly spaced ones in a turn, from an expansion
/// that starts at `start_phase` (radians in the turn). `report` must have room for all of them.
template <int N>
void put_samples(const Expansion<N>& motion, double start_phase, double end_phase, int wanted,
                 run::TurnReport& report) {
  const auto due = [wanted](int k) { return numerics::full_turn * k / wanted; };
  const int first = report.sample_count;
  int& next = report.sample_count;
  while (next < wanted && due(next) < end_phase) ++next;
  const std::size_t numbers = wanted > 0 ? report.samples.size() / static_cast<std::size_t>(wanted) : 0;
  motion.series().put_states(
      next - first, [&](int i) { return due(first + i) - start_phase; },
      report.samples.data() + static_cast<std::size_t>(first) * numbers);
}

/// Adds contact over the first `duration_rad` to `report`, and notes slips that reverse against one-way
/// friction; `modes` per contact.
template <int N>
void note_contact(Expansion<N>& motion, const std::vector<contact::Mode>& modes, double duration_rad,
                  run::TurnReport& report) {
  bool touching = false;
  for (std::size_t i = 0; i < modes.size(); ++i) {
    if (modes[i] == contact::Mode::open) continue;
    touching = true;
    if (motion.law(i).friction.constant != 0 && !report.slip_reversed)
      report.slip_reversed = slip_reverses(motion.contact(i), motion.order(), duration_rad);
  }
  if (touching) run::add_contact(duration_rad / numerics::full_turn, report);
}

}  // namespace rubsweep::integrate::taylor
