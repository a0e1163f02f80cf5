#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "rubsweep/core/response/spectrum/full_spectrum.hpp"
#include "rubsweep/measurement/scope/verdict.hpp"

namespace rubsweep::scope {

/// Number of turns at the end of a motion without a period; only their lines are in the table.
inline constexpr int most_aperiodic_turns = 64;

/// Highest order at which interpolation of the readings does not change the noise.
double most_order_looked_at(const Reading& reading);

/// Number of turns at the end of the motion; lines between the bins are computed from them.
inline constexpr std::size_t most_resolved_turns = 128;

/// Amplitude from which on a line at order 1 stands out of the noise, and floor of all orders.
struct LeastLine {
  double seen_m = 0, floor_m = 0;
};

/// Lines that stand out, by `least`, at any place between the bins, from the last turns of the motion. Where
/// the marks leave the angles open, the line that turns with the shaft gets the order 1.
std::vector<DiscreteLine> discrete_lines_of(std::span<const std::complex<double>> samples,
                                            std::size_t samples_per_revolution, const Reading& reading,
                                            LeastLine least,
                                            response::spectrum::SpectrumWorkspace& workspace);

/// Largest possible distance, in orders, of a motion's visible lines from the multiples of 1 / period,
/// including two standard uncertainties. It comes from the most accurate line. Only lines within a bin of a
/// multiple are used; of several lines near one multiple, only the largest; and none that are nearest to a
/// whole order. Empty where one of the lines is farther away than this uncertainty and 1/50 turn over the
/// recording.
std::optional<double> room_of_period(std::span<const std::complex<double>> samples,
                                     std::size_t samples_per_revolution, const Reading& reading, int period,
                                     LeastLine least, response::spectrum::SpectrumWorkspace& workspace);

/// Sets the uncertainty of every line in the table: noise and interpolation error. In a motion without a
/// period, a bin also has the distance from its line, or the leakage of other lines if it has none.
void add_uncertainties(const Reading& reading, Verdict& verdict);

}  // namespace rubsweep::scope
