#pragma once

#include <complex>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "rubsweep/core/response/spectrum/full_spectrum.hpp"
#include "rubsweep/measurement/scope/verdict.hpp"

namespace rubsweep::scope {

/// Turns whose lines are in the table of a motion without a period: its last ones.
inline constexpr int most_aperiodic_turns = 64;

/// Highest order whose noise the interpolation of the readings leaves as it is.
double most_order_looked_at(const Reading& reading);

/// Turns whose lines are looked for between the bins: the last ones.
inline constexpr std::size_t most_resolved_turns = 128;

/// Lines of a motion that are larger than `least_m`, wherever they stand between the bins, by its last turns.
/// Angles that the marks leave open are such that the line that turns with the shaft has the order 1.
std::vector<DiscreteLine> discrete_lines_of(std::span<const std::complex<double>> samples,
                                            std::size_t samples_per_revolution, const Reading& reading,
                                            double least_m, response::spectrum::SpectrumWorkspace& workspace);

/// How far the visible lines of a motion that stand within a bin of a multiple of 1 / period may stand beside
/// it, in orders: with two standard uncertainties, and that of the line which tells most. Empty where one of
/// them stands further beside it than these and a fiftieth of a turn over the recording. Of the lines about
/// one multiple the largest counts, lines nearest to a whole order count for nothing.
std::optional<double> room_of_period(std::span<const std::complex<double>> samples,
                                     std::size_t samples_per_revolution, const Reading& reading, int period,
                                     double visible_m, response::spectrum::SpectrumWorkspace& workspace);

/// Uncertainty of every line of the table: noise, what the interpolation of the readings misses, and of a bin
/// of a motion without a period how far it is from the line that stands there, or what other lines leave in
/// it.
void add_uncertainties(const Reading& reading, Verdict& verdict);

}  // namespace rubsweep::scope
