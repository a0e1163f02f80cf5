#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <vector>

#include "rubsweep/analysis/linear/bode.hpp"
#include "rubsweep/analysis/linear/linear_run.hpp"

namespace rubsweep::linear {

/// Sampling of the sensors.
struct Sampling {
  double sample_s = 1e-3;
  double noise_m = 0;  ///< standard deviation of white noise on every sample; the same numbers in every run
};

inline constexpr double most_samples = 1e6;  ///< Largest number of samples in one experiment.

/// Damped oscillation offset + e^{-ratio w t} amplitude cos(w sqrt(1 - ratio^2) t + phase) fitted to samples.
struct FreeDecay {
  double natural_frequency_hz = 0;  ///< undamped, w / 2 pi
  double damping_ratio = 0;
  double amplitude_m = 0;  ///< amplitude at the first sample
  double misfit = 0;       ///< square root of the unexplained share of the energy about the mean, 0..1
};

/// Response to the machine's kick at standstill, without its stops. A damped oscillation is fitted to each
/// sensor's signal after the first quarter, by which time faster modes have decayed.
struct FreeResponse {
  LinearRun run;
  Eigen::MatrixXd signal_m = {};  ///< samples x sensors
  std::vector<double> angle_deg;  ///< direction of each sensor
  std::vector<std::optional<FreeDecay>> decay =
      {};  ///< decay at each sensor; empty where the sensor does not measure the kick
};

/// Simulates the free response. The machine must have a kick.
FreeResponse free_response(const scene::PreparedMachine& machine, double duration_s,
                           const Sampling& sampling);

/// Speed ramp with an unbalance, without stops: amplitude and phase of 1X over the speed, and their maximum.
struct RunUp {
  LinearRun run;
  Eigen::MatrixXd signal_m = {};                  ///< samples x sensors
  std::vector<double> angle_deg;                  ///< direction of each sensor
  std::vector<std::vector<BodePoint>> bode = {};  ///< plot of each sensor
  std::vector<bool> sees = {};                    ///< flag of each sensor: it measures more than rounding
  /// Speed of the largest 1X during the ramp, for each sensor. Unless the ramp is slow, this speed differs
  /// from the critical speed, because the vibration lags. Empty where the sensor measures nothing, or 1X is
  /// largest at an end.
  std::vector<std::optional<double>> speed_of_largest_1x_hz = {};
  /// Mode at the largest 1X, for each sensor, without the effect of the ramp. Empty where there is no such
  /// speed or no fit.
  std::vector<std::optional<RampResonance>> resonance = {};
  std::vector<double> largest_amplitude_m = {};  ///< largest amplitude of 1X at each sensor
};

/// Undamped frequency of the slowest free vibration. Use at least two samples in its period.
double lowest_frequency_hz(const scene::PreparedMachine& machine);

/// Simulates a run-up. Windows have `bode_revolutions`; rate_hz_per_s has the sign of to - from.
RunUp run_up(const scene::PreparedMachine& machine, double from_hz, double to_hz, double rate_hz_per_s,
             double eccentricity_m, const Sampling& sampling);
inline constexpr int bode_revolutions = 10;

/// Least-squares fit to equidistant samples, at least 16. Starts from the largest spectral line, so that it
/// finds the strongest mode. Throws ConfigError for fewer samples or a constant signal, SolverError where the
/// fit does not converge.
FreeDecay fit_free_decay(std::span<const double> displacement_m, double sample_s);

}  // namespace rubsweep::linear
