#pragma once

#include <complex>
#include <string>
#include <vector>

#include "rubsweep/measurement/recording/recording.hpp"

namespace rubsweep::scope {

/// Most by which the speed of a steady machine differs between two stretches of history_turns, relative to
/// it.
inline constexpr double steady_share = 0.02;
/// Turns that are looked at together, so that multiples of 1/8 have a line of their own.
inline constexpr int history_turns = 8;

/// Whether the speed changes by more than steady_share: a run-up, a coast-down or a machine that hunts.
bool speed_changes(const recording::Recording& recording);

/// Component of one order of a signal over a few turns: Re(A e^{i order phi}), phi = 0 at the mark.
struct OrderPoint {
  double t_s = 0, speed_hz = 0;           ///< time and speed in the middle of these turns
  std::complex<double> x_m = 0, y_m = 0;  ///< A of the displacement in x and in y; of one probe x alone
};

/// A Bode plot of an order that is a multiple of 1/8: one point a turn, of the least number of turns from
/// `turns` on in which the order goes round a whole number of times. Over these turns
/// the mean adds nothing to it. Orders other than 1 are taken over twice as many turns under a Hann window,
/// where there are so many: 1X, which grows in a resonance, would else be seen in them.
std::vector<OrderPoint> order_history(const recording::Recording& recording, double order, int turns = 2);

/// t_s, speed_hz, order, x_amplitude_m, x_phase_deg, y_amplitude_m, y_phase_deg of several orders; phases
/// from 0 to -360, negative ones lag behind the mark.
std::string bode_csv(const recording::Recording& recording, const std::vector<double>& orders);

/// t_s, speed_hz, order, amplitude_m: full spectra of twice history_turns under a Hann window, one every
/// history_turns, at most 120 of them, up to |order| 8. Of fewer turns one spectrum of history_turns, if
/// there are so many.
std::string waterfall_csv(const recording::Recording& recording);

}  // namespace rubsweep::scope
