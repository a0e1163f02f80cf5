#pragma once

#include <complex>
#include <span>
#include <vector>

#include "rubsweep/core/response/spectrum/full_spectrum.hpp"

namespace rubsweep::response::spectrum {

/// A line under a Hann window covers this many bins on either side of its peak.
inline constexpr int hann_half_width = 2;

/// Share of the energy about the mean in every bin of the Hann-windowed spectrum, in the order of
/// FullSpectrum; sums to 1, or all zero for samples that do not change.
std::vector<double> energy_shares(std::span<const std::complex<double>> samples,
                                  SpectrumWorkspace& workspace);

/// Lines it takes to hold `share` of the energy: the largest bin and two on either side of it are a line,
/// then the largest bin left, and so on.
int lines_holding(std::span<const double> energy_shares, double share);

/// Share of the energy that stands in other lines in `second` than in `first`: half the sum of the absolute
/// differences, after both are smoothed over the width of a line. 0 to 1.
double moved_share(std::span<const double> first, std::span<const double> second);

/// True when both stretches of equal length hold 99 % of their energy in at most 16 lines, and no more than 1
/// % of it stands in other lines in one than in the other. Once-per-turn samples will do: lines then stand at
/// their orders modulo 1, discrete as before. SolverError when the lengths differ or are zero.
bool same_discrete_lines(std::span<const std::complex<double>> first,
                         std::span<const std::complex<double>> second, SpectrumWorkspace& workspace);

}  // namespace rubsweep::response::spectrum
