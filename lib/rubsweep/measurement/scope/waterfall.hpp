#pragma once

#include <complex>
#include <string>
#include <vector>

#include "rubsweep/measurement/recording/recording.hpp"

namespace rubsweep::scope {

/// Largest relative difference of speed between two stretches of history_turns in a machine that counts as
/// steady.
inline constexpr double steady_share = 0.02;
/// Number of turns evaluated together, so that multiples of order 1/8 fall onto bins.
inline constexpr int history_turns = 8;

/// Whether the speed changes by more than steady_share: a run-up, a coast-down or a hunting machine.
bool speed_changes(const recording::Recording& recording);

/// Component of one order over a few turns: Re(A e^{i order phi}), phi = 0 at the mark.
struct OrderPoint {
  double t_s = 0, speed_hz = 0;           ///< time and speed in the middle of these turns
  std::complex<double> x_m = 0, y_m = 0;  ///< A of the displacement in x and in y; with one probe x only
};

/// Bode plot of an order that is a multiple of 1/8, one point per turn. Each point uses the smallest number
/// of turns, `turns` or more, that holds whole periods of the order, so that the mean of the signal does not
/// contribute. Orders other than 1 use twice as many turns, if available, and a Hann window: otherwise a
/// growing 1X near a resonance would leak into them.
std::vector<OrderPoint> order_history(const recording::Recording& recording, double order, int turns = 2);

/// CSV with t_s, speed_hz, order, x_amplitude_m, x_phase_deg, y_amplitude_m, y_phase_deg of several orders.
/// Phases go from 0 to -360 degrees; negative phases lag behind the mark.
std::string bode_csv(const recording::Recording& recording, const std::vector<double>& orders);

/// CSV with t_s, speed_hz, order, amplitude_m: full spectra over twice history_turns under a Hann window, up
/// to |order| 8. One spectrum every history_turns, at most 120. A shorter recording has one spectrum over
/// history_turns, if it has that many turns.
std::string waterfall_csv(const recording::Recording& recording);

}  // namespace rubsweep::scope
