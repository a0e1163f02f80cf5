#pragma once

#include <complex>
#include <span>
#include <vector>

#include "rubsweep/core/response/spectrum/full_spectrum.hpp"

namespace rubsweep::response::spectrum {

/// Samples about their mean that come and go smoothly, so that a line which is none of the spectrum's own, or
/// grows as in a resonance, has no skirt over all orders. A steady line keeps its amplitude.
std::vector<std::complex<double>> under_hann_window(std::span<const std::complex<double>> samples);

/// full_spectrum of the samples under the window, 0X as without it. A line has half its height at its
/// neighbours, too.
FullSpectrum windowed_spectrum(std::span<const std::complex<double>> displacement_m, int turns,
                               SpectrumWorkspace& workspace);

}  // namespace rubsweep::response::spectrum
