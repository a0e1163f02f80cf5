#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "rubsweep/integrate/run/options.hpp"
#include "rubsweep/integrate/run/outcome.hpp"
#include "rubsweep/ramp/speed_ramp.hpp"
#include "rubsweep/scene/prepared_machine.hpp"

namespace rubsweep::ramp {

/// The rotor at one instant of a ramp.
struct RampSample {
  double t_s = 0;
  Eigen::Vector2d displacement_m{0, 0}, velocity_m_per_s{0, 0};
};

/// A stretch of a ramp as long as one turn at its fastest speed; the last one is shorter.
struct RampStretch {
  double begin_s = 0, end_s = 0;
  std::vector<RampSample> samples;  ///< at equal distances from the begin on, the end left out
  int hits = 0;                     ///< contacts that began
  double touching_s = 0;            ///< time with at least one contact touching
  bool touched = false;
  double peak_displacement_m = 0;
  double peak_contact_force_n = 0;
};

/// Runs a machine with its stops while its shaft speed changes, by dopri5 with every change of contact mode
/// located, and hands on stretch by stretch with `samples` samples each. The unbalance forces e Re(U (phi'^2
/// - i phi'') e^{i phi}), the gyroscopic moment, damping that turns with the shaft and the speed of the
/// rubbing surfaces follow phi'. It starts on the quiet motion of the first speed with the mark of the shaft
/// along +x; at rest in the static position where that motion touches. The machine's kick is left out.
/// Returns how the run ended; after a failure no stretch follows. Throws ConfigError for what no ramp is made
/// of: faulty bearings, static forces that press the rotor through a wall, a speed without quiet motion.
integrate::run::Outcome run_ramp(const scene::PreparedMachine& machine, const SpeedRamp& ramp,
                                 const integrate::run::SolverOptions& solver, int samples,
                                 const std::function<void(const RampStretch&)>& on_stretch);

}  // namespace rubsweep::ramp
