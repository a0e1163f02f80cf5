#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include "rubsweep/core/response/spectrum/full_spectrum.hpp"
#include "rubsweep/measurement/scope/verdict.hpp"

namespace rubsweep::scope {

/// Turns whose lines are in the table of a motion without a period: its last ones.
inline constexpr int most_aperiodic_turns = 64;

/// Highest order whose noise the interpolation of the readings leaves as it is.
double most_order_looked_at(const Reading& reading);

/// Lines of a motion without a period, wherever they stand between the bins, by its last turns; `verdict`
/// says how many the table of bins has, and the smallest line that counts.
std::vector<DiscreteLine> discrete_lines_of(std::span<const std::complex<double>> samples,
                                            std::size_t samples_per_revolution, const Reading& reading,
                                            const Verdict& verdict,
                                            response::spectrum::SpectrumWorkspace& workspace);

/// Uncertainty of every line of the table: noise, what the interpolation of the readings misses, and of a bin
/// of a motion without a period how far it is from the line that stands there, or what other lines leave in
/// it.
void add_uncertainties(const Reading& reading, Verdict& verdict);

}  // namespace rubsweep::scope
