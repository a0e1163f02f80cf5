#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/integrate/run/outcome.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"

namespace rubsweep::ramp {

/// Shaft speed that changes at a constant rate, with an unbalance. The shaft angle is phi = 2 pi (from t +
/// rate t^2 / 2).
struct SpeedRamp {
  double from_hz = 0, to_hz = 0;  ///< > 0
  double rate_hz_per_s = 0;       ///< sign of to - from, not 0
  double eccentricity_m = 0;

  double duration_s() const { return (to_hz - from_hz) / rate_hz_per_s; }
  double fastest_hz() const { return std::max(from_hz, to_hz); }
  double speed_hz(double t_s) const { return from_hz + rate_hz_per_s * t_s; }
  double angle_rad(double t_s) const {
    return 2 * std::numbers::pi * (from_hz * t_s + rate_hz_per_s * t_s * t_s / 2);
  }
  /// Time in s at which the shaft has made `turns` turns, or as many as the ramp has.
  double time_s(double turns) const {
    return 2 * turns / (from_hz + std::sqrt(std::max(0.0, from_hz * from_hz + 2 * rate_hz_per_s * turns)));
  }
};

/// State of the rotor at one instant of a ramp.
struct RampSample {
  double t_s = 0;
  Eigen::Vector2d displacement_m{0, 0}, velocity_m_per_s{0, 0};
};

/// Part of a ramp, as long as one turn at the ramp's fastest speed; the last part is shorter.
struct RampStretch {
  double begin_s = 0, end_s = 0;
  std::vector<RampSample> samples;  ///< equidistant samples, including the begin but not the end
  int hits = 0;                     ///< number of contacts that began
  double touching_s = 0;            ///< time with at least one contact touching
  bool touched = false;
  double peak_displacement_m = 0;
  double peak_contact_force_n = 0;
};

/// Runs a machine with its stops while its shaft speed changes, by dopri5 with every change of contact mode
/// located. `on_stretch` gets each stretch with `samples` samples. The unbalance forces are e Re(U (phi'^2 -
/// i phi'') e^{i phi}). Gyroscopic moment, rotating damping and speed of the rubbing surfaces follow phi'.
/// The run starts on the quiet motion of the first speed, with the mark of the shaft along +x; if that motion
/// touches, it starts at rest in the static position. The machine's kick is left out. Returns how the run
/// ended; no stretch follows after a failure. Throws ConfigError for machines that a ramp cannot handle:
/// faulty bearings, static forces that press the rotor through a wall, a speed without quiet motion.
integrate::run::Outcome run_ramp(const scene::PreparedMachine& machine, const SpeedRamp& ramp,
                                 const integrate::run::SolverOptions& solver, int samples,
                                 const std::function<void(const RampStretch&)>& on_stretch);

}  // namespace rubsweep::ramp
