#pragma once

#include <complex>
#include <span>
#include <vector>

#include "rubsweep/core/response/spectrum/full_spectrum.hpp"

namespace rubsweep::response::spectrum {

/// A line A e^{2 pi i f k} of samples z_k, at any place between the bins of their transform.
struct ResolvedLine {
  double frequency = 0;                ///< f in cycles per sample, from -1/2 to 1/2
  std::complex<double> amplitude = 0;  ///< A, with its phase at the first sample
  double frequency_uncertainty = 0;    ///< standard uncertainty
  double amplitude_uncertainty = 0;    ///< standard uncertainty of each component
};

/// Limits of a search for lines.
struct LineSearch {
  int most_lines = 16;
  bool about_mean = true;               ///< true: the mean is no line, and no line lies within two bins of it
  double least_amplitude = 0;           ///< smaller lines are ignored
  double lowest = -0.5, highest = 0.5;  ///< range of frequencies
};

/// Lines of samples, the largest first. The largest line of the remainder under a Hann window is subtracted;
/// then each line is estimated again with all others removed (RELAX: J. Li, P. Stoica 1996). Uncertainties
/// include the noise beside the line and the error of the method: half of the difference between both halves
/// of the samples, beyond their noise. Lines less than two bins apart cannot be separated. Needs 16 samples
/// or more.
std::vector<ResolvedLine> resolve_lines(std::span<const std::complex<double>> samples,
                                        const LineSearch& search, SpectrumWorkspace& workspace);

}  // namespace rubsweep::response::spectrum
