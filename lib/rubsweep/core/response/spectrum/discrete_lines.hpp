#pragma once

#include <complex>
#include <span>
#include <vector>

#include "rubsweep/core/response/spectrum/full_spectrum.hpp"

namespace rubsweep::response::spectrum {

/// Samples about their mean under a window 1 - cos(2 pi (k + 1/2) / N), by which they come and go smoothly: a
/// line which is none of the spectrum's own, or grows as in a resonance, has no skirt over all orders. A
/// steady line keeps its amplitude.
std::vector<std::complex<double>> under_hann_window(std::span<const std::complex<double>> samples);

/// The same about the mean under the window, which a line that grows does not shift.
std::vector<std::complex<double>> under_hann_window_of_growing(std::span<const std::complex<double>> samples);

/// full_spectrum of the samples under the window, 0X as without it. A line has half its height at its
/// neighbours, too.
FullSpectrum windowed_spectrum(std::span<const std::complex<double>> displacement_m, int turns,
                               SpectrumWorkspace& workspace);

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
