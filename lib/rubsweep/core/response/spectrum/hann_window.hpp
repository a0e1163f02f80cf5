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
std::vector<std::complex<double>> under_hann_window_of_growing(
    std::span<const std::complex<double>> samples);

/// full_spectrum of the samples under the window, 0X as without it. A line has half its height at its
/// neighbours, too.
FullSpectrum windowed_spectrum(std::span<const std::complex<double>> displacement_m, int turns,
                               SpectrumWorkspace& workspace);

}  // namespace rubsweep::response::spectrum
