#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "rubsweep/core/response/spectrum/full_spectrum.hpp"
#include "rubsweep/measurement/scope/verdict.hpp"

namespace rubsweep::scope {

/// Number of turns, at the end of a motion without a period, whose lines are in the table.
inline constexpr int most_aperiodic_turns = 64;

/// Highest order at which interpolation of the readings does not change the noise.
double most_order_looked_at(const Reading& reading);

/// Number of turns, at the end of the motion, in which lines between the bins are resolved.
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

/// Possible distance, in orders, of a motion's visible lines from the multiples of 1 / period, including two
/// standard uncertainties; the most accurate line decides. Only lines within a bin of a multiple count. Empty
/// where one of them is farther away than this uncertainty and 1/50 turn over the recording. Of several lines
/// near one multiple the largest counts; lines nearest to a whole order do not count.
std::optional<double> room_of_period(std::span<const std::complex<double>> samples,
                                     std::size_t samples_per_revolution, const Reading& reading, int period,
                                     LeastLine least, response::spectrum::SpectrumWorkspace& workspace);

/// Displacement over whole turns of samples that are its derivatives (Recording::measured_m): each line over
/// (i order)^times, those below the lowest order left out.
std::vector<std::complex<double>> displacement_of(std::vector<std::complex<double>> samples, int turns,
                                                  const recording::Integration& integration,
                                                  response::spectrum::SpectrumWorkspace& workspace);

/// Sets the uncertainty of every line in the table: noise and interpolation error. In a motion without a
/// period, a bin also has its distance from the line that stands there, or the leakage of other lines.
void add_uncertainties(const Reading& reading, Verdict& verdict);

}  // namespace rubsweep::scope
