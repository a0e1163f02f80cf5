#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <complex>
#include <cstddef>
#include <vector>

#include "rubsweep/core/integrate/exact/modes/harmonic_response.hpp"
#include "rubsweep/core/integrate/run/pulse_times.hpp"
#include "rubsweep/core/integrate/run/scaled_system.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::integrate::exact {

/// A harmonic force, divided by the mass: the acceleration is Re(acceleration e^{i rate t}). Lengths are
/// scaled, time is in seconds.
struct Drive {
  Eigen::VectorXcd acceleration;              ///< forcing of each coordinate, scaled length per s^2
  std::vector<std::complex<double>> closing;  ///< acceleration along each contact's normal
  double rate = 0;                            ///< rad/s
};

/// Phasors e^{i rate t} of the unbalance and of the pulses, or factors that advance them.
struct Phasors {
  std::complex<double> shaft{1};
  std::vector<std::complex<double>> pulses{};
};

/// Harmonic forces on an exact motion: the unbalance, and the pulses of the scene that act now. The parts of
/// a second harmonic are pulses that always act.
class Drives {
 public:
  /// `system`: the scaled system with time in seconds.
  Drives(const scene::Scene& scene, const Eigen::MatrixXd& inverse_mass,
         const run::ScaledSystem<Eigen::Dynamic>& system);

  const Drive& unbalance() const { return unbalance_; }
  const std::vector<Drive>& pulses() const { return pulses_; }
  /// Indices of the acting pulses, ascending: their phasors have this order.
  const std::vector<std::size_t>& acting() const { return acting_; }
  /// Highest angular frequency of the acting forces, or `other` if that is higher.
  double fastest_rad_per_s(double other) const {
    double fastest = std::max(other, unbalance_.rate);
    for (const std::size_t i : acting_) fastest = std::max(fastest, pulses_[i].rate);
    return fastest;
  }

  /// Sets the phasors for a phase of the shaft; from here on no pulse of the scene acts.
  void start(double phase_rad, Phasors& phasors);
  /// Sets the phasors, with the pulses that act at `time_s` in the revolution of `times` (in seconds).
  void start(double phase_rad, const run::PulseTimes& times, double time_s, Phasors& phasors);

  void turn(Phasors& phasors, double duration_s) const {
    phasors.shaft = modes::product(phasors.shaft, turn_of(unbalance_, duration_s));
    for (std::size_t k = 0; k < acting_.size(); ++k)
      phasors.pulses[k] = modes::product(phasors.pulses[k], turn_of(pulses_[acting_[k]], duration_s));
  }
  /// Factors that advance all phasors by a duration, including those of pulses that do not act now.
  Phasors turns(double duration_s) const;
  /// Advances the phasors by such factors.
  void turn(Phasors& phasors, const Phasors& by) const {
    phasors.shaft = modes::product(phasors.shaft, by.shaft);
    for (std::size_t k = 0; k < acting_.size(); ++k)
      phasors.pulses[k] = modes::product(phasors.pulses[k], by.pulses[acting_[k]]);
  }

  /// Adds the acceleration of coordinate `j`; `add_closing`: that of contact `i` along its normal.
  void add_acceleration(Eigen::Index j, const Phasors& phasors, double& sum) const {
    sum += modes::real_product(unbalance_.acceleration(j), phasors.shaft);
    for (std::size_t k = 0; k < acting_.size(); ++k)
      sum += modes::real_product(pulses_[acting_[k]].acceleration(j), phasors.pulses[k]);
  }
  void add_closing(std::size_t i, const Phasors& phasors, double& sum) const {
    sum += modes::real_product(unbalance_.closing[i], phasors.shaft);
    for (std::size_t k = 0; k < acting_.size(); ++k)
      sum += modes::real_product(pulses_[acting_[k]].closing[i], phasors.pulses[k]);
  }

 private:
  static std::complex<double> turn_of(const Drive& drive, double duration_s) {
    return std::polar(1.0, drive.rate * duration_s);
  }

  Drive unbalance_;
  std::vector<Drive> pulses_;
  std::vector<double> ahead_rad_;  ///< phase angles, at phase 0 of the shaft, of the drives that always act
  std::vector<std::size_t> acting_;
};

}  // namespace rubsweep::integrate::exact
