#pragma once

#include <algorithm>
#include <cmath>

#include "rubsweep/core/response/spectrum/full_spectrum.hpp"
#include "rubsweep/measurement/scope/verdict.hpp"

namespace rubsweep::scope {

inline constexpr int fewest_periods = 3;  ///< Fewest repetitions in which a period is found.

/// Longest period, in turns, that a motion over so many turns can show.
constexpr int longest_period_in(int turns) { return std::min(max_period, turns / fewest_periods); }

/// A spectrum of which only the lines up to a given order are used.
struct Lines : response::spectrum::FullSpectrum {
  double most_order = 0, least_share = 0;
  recording::Integration integration{};

  /// Noise at line k over that at order 1.
  double noise_at(int k) const { return integration.noise_at(order(k)); }
};

/// Calls `look` with number and amplitude of each line of the displacement that counts, except 0X. Noise is
/// white in what was measured.
template <class Look>
void for_lines(const Lines& spectrum, Look look) {
  const int last = static_cast<int>(spectrum.most_order * spectrum.turns);
  for (int k = std::max(-last, spectrum.first_line()); k <= std::min(last, spectrum.last_line()); ++k)
    if (k != 0 && std::abs(spectrum.order(k)) >= spectrum.integration.lowest_order)
      look(k, spectrum.amplitude(k) * spectrum.noise_at(k));
}

/// Amplitudes at order 1 that noise reaches rarely, and the floor of all orders, in metres.
struct Threshold {
  double noise_m = 0;       ///< standard deviation of each component of a line
  double suspicious_m = 0;  ///< amplitude that noise exceeds in a fifth of all recordings
  double largest_m = 0;     ///< largest line
  double seen_m = 0;   ///< smallest line that exceeds the noise, however small a part of the motion it is
  double floor_m = 0;  ///< smallest line that counts, whatever the noise

  /// Smallest line that counts where the noise is so many times that at order 1.
  double visible_m(double noise = 1) const { return std::max(noise * seen_m, floor_m); }
};

/// Thresholds of a spectrum; its noise comes from the median of the lines that belong to no period.
Threshold threshold_of(const Lines& spectrum);

/// A line, and the noise there over that at order 1.
struct Beside {
  double amplitude_m = 0, noise = 1;
};

/// The line that is no multiple of 1/n and stands highest over its noise; if a period is given, only
/// multiples of 1 / period count.
Beside highest_beside(const Lines& spectrum, int n, int period = 0);

/// Whether a line is visible that is no multiple of 1/n.
bool is_visible_beside(const Lines& spectrum, int n, const Threshold& threshold);

}  // namespace rubsweep::scope
