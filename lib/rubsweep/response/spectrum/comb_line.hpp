#pragma once

#include <complex>
#include <optional>
#include <span>

#include "rubsweep/response/spectrum/full_spectrum.hpp"

namespace rubsweep::response::spectrum {

/// Largest line of a comb 1 + k spacing, |k| <= 16, but 0X; its order is exact, not that of the nearest bin,
/// and its amplitude does not suffer from standing between two bins: |sum w_j z_j e^{-2 pi i order t_j}| /
/// sum w_j over all samples under a Hann window w, t in turns. Neighbours 4 bins or more away leak less than
/// 1 % of themselves. Empty when all amplitudes are zero. `displacement_m`: samples of z, any unit serves.
std::optional<SpectralLine> largest_comb_line(std::span<const std::complex<double>> displacement_m,
                                              int samples_per_revolution, double spacing);

}  // namespace rubsweep::response::spectrum
