#pragma once

#include <complex>
#include <span>
#include <vector>

#include "rubsweep/core/response/spectrum/full_spectrum.hpp"

namespace rubsweep::response::spectrum {

/// A line A e^{2 pi i f k} of samples z_k, wherever it stands between the bins of their transform.
struct ResolvedLine {
  double frequency = 0;                ///< f in cycles a sample, from -1/2 to 1/2
  std::complex<double> amplitude = 0;  ///< A, with its phase at the first sample
  double frequency_uncertainty = 0;    ///< standard
  double amplitude_uncertainty = 0;    ///< standard, of each component
};

/// Lines that are looked for.
struct LineSearch {
  int most_lines = 16;
  bool about_mean = true;               ///< the mean is no line, and none stands within two bins of it
  double least_amplitude = 0;           ///< smaller ones are not looked for
  double lowest = -0.5, highest = 0.5;  ///< frequencies that are looked at
};

/// Lines of samples, the largest first. The largest line of what is left, under a Hann
/// window, is subtracted, and then each line again with all others taken away (RELAX: J. Li, P. Stoica 1996).
/// Uncertainties hold the noise beside the line, and the method's own: half of what both halves of the
/// samples differ by, beyond their noise. Lines less than two bins apart are not told from each other. Needs
/// 16 samples or more.
std::vector<ResolvedLine> resolve_lines(std::span<const std::complex<double>> samples,
                                        const LineSearch& search, SpectrumWorkspace& workspace);

}  // namespace rubsweep::response::spectrum
