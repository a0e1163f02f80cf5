#include "rubsweep/core/integrate/exact/drives.hpp"

#include <numbers>

#include "rubsweep/core/integrate/run/second_harmonic.hpp"
#include "rubsweep/core/integrate/run/state_scale.hpp"

namespace rubsweep::integrate::exact {
namespace {

using Complex = std::complex<double>;

Drive drive_of(const Eigen::VectorXcd& acceleration, double rate_rad_per_s,
               const run::ScaledSystem<Eigen::Dynamic>& system) {
  Drive drive{.acceleration = acceleration, .closing = {}, .rate = rate_rad_per_s};
  for (const auto& contact : system.contacts) {
    drive.closing.emplace_back(contact.first_row.dot(drive.acceleration.real()),
                               contact.first_row.dot(drive.acceleration.imag()));
  }
  return drive;
}

}  // namespace

Drives::Drives(const scene::Scene& scene, const Eigen::MatrixXd& inverse_mass,
               const run::ScaledSystem<Eigen::Dynamic>& system) {
  const Eigen::MatrixXcd per_force =
      inverse_mass.cast<Complex>() / run::state_scale(scene).in_seconds().unit_acceleration_m_per_s2();
  unbalance_ = drive_of(per_force * scene.harmonic_n, scene.speed_rad_per_s, system);
  for (const scene::Pulse& pulse : scene.pulses) {
    pulses_.push_back(
        drive_of(Complex(0, -pulse.force_n) * (per_force * pulse.direction.template cast<Complex>()),
                 std::numbers::pi / pulse.duration_s, system));
  }
  for (const run::HarmonicPart& part : run::second_harmonic(scene)) {
    pulses_.push_back(drive_of(Complex(0, -1) * (per_force * part.top_n.cast<Complex>()),
                               2 * scene.speed_rad_per_s, system));
    ahead_rad_.push_back(4 * std::numbers::pi * part.turns_ahead);
  }
  acting_.reserve(pulses_.size());
}

void Drives::start(double phase_rad, Phasors& phasors) {
  phasors.shaft = std::polar(1.0, phase_rad);
  acting_.clear();
  phasors.pulses.clear();
  for (std::size_t k = 0; k < ahead_rad_.size(); ++k) {
    acting_.push_back(pulses_.size() - ahead_rad_.size() + k);
    phasors.pulses.push_back(std::polar(1.0, 2 * phase_rad + ahead_rad_[k]));
  }
}

void Drives::start(double phase_rad, const run::PulseTimes& times, double time_s, Phasors& phasors) {
  phasors.shaft = std::polar(1.0, phase_rad);
  acting_.clear();
  phasors.pulses.clear();
  for (const std::size_t i : times.acting()) {
    acting_.push_back(i);
    phasors.pulses.push_back(std::polar(1.0, times.angle_rad(i, time_s)));
  }
}

Phasors Drives::turns(double duration_s) const {
  Phasors by{.shaft = turn_of(unbalance_, duration_s)};
  for (const Drive& pulse : pulses_) by.pulses.push_back(turn_of(pulse, duration_s));
  return by;
}

}  // namespace rubsweep::integrate::exact
