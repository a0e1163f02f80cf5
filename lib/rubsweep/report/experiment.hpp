#pragma once

#include <string>

#include "rubsweep/integrate/linear_run.hpp"

namespace rubsweep::report {

/// The preliminary experiments on a rotor, without its stops: what the sensors read, and what follows from
/// it.
struct Experiment {
  std::string sensors_csv;         ///< t_s, speed_hz, shaft_angle_rad, then sensor_i_m
  std::string bode_csv;            ///< run-up only: speed_hz, then sensor_i_amplitude_m, sensor_i_phase_deg
  std::string identification_csv;  ///< quantity, sensor, value
  std::string summary;             ///< for a terminal
};

/// How the sensors read.
struct Sampling {
  double sample_s = 1e-3;
  double noise_m = 0;  ///< standard deviation of white noise on every sample; the same numbers in every run
};

/// Most samples of one experiment.
inline constexpr double most_samples = 1e6;

/// Response to the machine's kick at standstill. A damped oscillation is fitted to each sensor's signal after
/// the first quarter, when faster modes are gone. The machine needs a kick. Throws ConfigError where a sensor
/// sees nothing.
Experiment free_response(const scene::Plan& plan, double duration_s, const Sampling& sampling);

/// Speed ramp with the unbalance of `eccentricity_m`: 1X amplitude and phase over speed by windows of
/// `bode_revolutions`, and the critical speed. rate_hz_per_s has the sign of to - from.
Experiment run_up(const scene::Plan& plan, double from_hz, double to_hz, double rate_hz_per_s,
                  double eccentricity_m, const Sampling& sampling);
inline constexpr int bode_revolutions = 10;

}  // namespace rubsweep::report
