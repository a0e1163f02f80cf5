#pragma once

#include <span>

namespace rubsweep::linear {

/// A damped oscillation offset + e^{-ratio w t} amplitude cos(w sqrt(1 - ratio^2) t + phase) through samples.
struct FreeDecay {
  double natural_frequency_hz = 0;  ///< undamped, w / 2 pi
  double damping_ratio = 0;
  double amplitude_m = 0;  ///< at the first sample
  double misfit = 0;       ///< root of the unexplained share of the signal's energy about its mean, 0..1
};

/// Least-squares fit over equidistant samples, at least 16; starts from the largest line of the spectrum, so
/// that the strongest mode is the one that is found. Throws ConfigError for fewer samples or a signal that
/// does not move, SolverError where the fit does not settle.
FreeDecay fit_free_decay(std::span<const double> displacement_m, double sample_s);

}  // namespace rubsweep::linear
