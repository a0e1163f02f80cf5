#pragma once

#include <complex>
#include <span>
#include <vector>

#include "rubsweep/core/response/spectrum/full_spectrum.hpp"

namespace rubsweep::response::spectrum {

/// Samples about their mean under a window 1 - cos(2 pi (k + 1/2) / N), which fades them in and out. A line
/// between two bins, or one that grows as in a resonance, then has no skirt over all orders. A steady line
/// keeps its amplitude.
std::vector<std::complex<double>> under_hann_window(std::span<const std::complex<double>> samples);

/// Samples under a Hann window, minus their mean under this window, which a growing line does not shift.
std::vector<std::complex<double>> under_hann_window_of_growing(std::span<const std::complex<double>> samples);

/// full_spectrum of the samples under the window, with the true 0X. A line also appears in both neighbouring
/// bins, at half its height.
FullSpectrum windowed_spectrum(std::span<const std::complex<double>> displacement_m, int turns,
                               SpectrumWorkspace& workspace);

/// Number of bins that a line under a Hann window covers on either side of its peak.
inline constexpr int hann_half_width = 2;

/// Share of the energy about the mean in every bin of the Hann-windowed spectrum, in the order of
/// FullSpectrum. The sum is 1, or 0 for constant samples.
std::vector<double> energy_shares(std::span<const std::complex<double>> samples,
                                  SpectrumWorkspace& workspace);

/// Smallest number of lines that hold `share` of the energy. The largest bin and two bins on either side of
/// it form a line, then the largest remaining bin, and so on.
int lines_holding(std::span<const double> energy_shares, double share);

/// Share of the energy, 0 to 1, that is in different lines in `second` than in `first`: half the sum of the
/// absolute differences, after both are smoothed over the width of a line.
double moved_share(std::span<const double> first, std::span<const double> second);

/// Whether two stretches of equal length each hold 99 % of their energy in at most 16 lines, with at most 1 %
/// of it in different lines. Once-per-turn samples are allowed: lines are then at their orders modulo 1, but
/// still discrete. SolverError when the lengths differ or are zero.
bool same_discrete_lines(std::span<const std::complex<double>> first,
                         std::span<const std::complex<double>> second, SpectrumWorkspace& workspace);

}  // namespace rubsweep::response::spectrum
