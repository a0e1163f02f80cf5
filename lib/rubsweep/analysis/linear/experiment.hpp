#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "rubsweep/analysis/linear/bode.hpp"
#include "rubsweep/analysis/linear/linear_run.hpp"
#include "rubsweep/analysis/linear/ramp_resonance.hpp"

namespace rubsweep::linear {

/// How the sensors read.
struct Sampling {
  double sample_s = 1e-3;
  double noise_m = 0;  ///< standard deviation of white noise on every sample; the same numbers in every run
};

/// Most samples of one experiment.
inline constexpr double most_samples = 1e6;

/// A damped oscillation offset + e^{-ratio w t} amplitude cos(w sqrt(1 - ratio^2) t + phase) through samples.
struct FreeDecay {
  double natural_frequency_hz = 0;  ///< undamped, w / 2 pi
  double damping_ratio = 0;
  double amplitude_m = 0;  ///< amplitude at the first sample
  double misfit = 0;       ///< root of the unexplained share of the signal's energy about its mean, 0..1
};

/// Response to the machine's kick at standstill, without its stops. A damped oscillation is fitted to each
/// sensor's signal after the first quarter, when faster modes are gone.
struct FreeResponse {
  LinearRun run;
  Eigen::MatrixXd signal_m;       ///< samples x sensors
  std::vector<double> angle_deg;  ///< direction of each sensor
  std::vector<std::optional<FreeDecay>>
      decay;  ///< decay at each sensor; empty where it does not see the kick
};

/// The machine needs a kick.
FreeResponse free_response(const scene::PreparedMachine& machine, double duration_s,
                           const Sampling& sampling);

/// Speed ramp with an unbalance, without stops: 1X amplitude and phase over speed, and where 1X is largest.
struct RunUp {
  LinearRun run;
  Eigen::MatrixXd signal_m;                  ///< samples x sensors
  std::vector<double> angle_deg;             ///< direction of each sensor
  std::vector<std::vector<BodePoint>> bode;  ///< plot of each sensor
  std::vector<bool> sees;                    ///< flag of each sensor: it reads more than rounding
  /// Per sensor: speed of the largest 1X during the ramp, behind the critical speed unless the ramp is slow;
  /// empty where one sees nothing or 1X is largest at an end.
  std::vector<std::optional<double>> speed_of_largest_1x_hz;
  /// Per sensor: the mode behind the largest 1X, freed of the ramp; empty where there is no such speed or no
  /// fit.
  std::vector<std::optional<RampResonance>> resonance;
  std::vector<double> largest_amplitude_m;  ///< largest amplitude of 1X at each sensor
};

/// Frequency of the slowest free vibration, undamped: one with fewer than two samples a period is not seen.
double lowest_frequency_hz(const scene::PreparedMachine& machine);

/// Windows of `bode_revolutions`; rate_hz_per_s has the sign of to - from.
RunUp run_up(const scene::PreparedMachine& machine, double from_hz, double to_hz, double rate_hz_per_s,
             double eccentricity_m, const Sampling& sampling);
inline constexpr int bode_revolutions = 10;

/// Least-squares fit over equidistant samples, at least 16; starts from the largest line of the spectrum, so
/// that the strongest mode is the one that is found. Throws ConfigError for fewer samples or a signal that
/// does not move, SolverError where the fit does not settle.
FreeDecay fit_free_decay(std::span<const double> displacement_m, double sample_s);

}  // namespace rubsweep::linear
