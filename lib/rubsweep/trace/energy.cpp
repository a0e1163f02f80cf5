#include "rubsweep/trace/energy.hpp"

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

namespace rubsweep::trace {
namespace {

/// Sum of all forces on the structure that neither its own matrices nor its contacts give.
Eigen::VectorXd forcing_n(const scene::Scene& scene, double turns) {
  const std::complex<double> turn = std::polar(1.0, 2 * std::numbers::pi * (turns - std::floor(turns)));
  Eigen::VectorXd force = scene.constant_n + (scene.harmonic_n * turn).real();
  if (scene.second_harmonic_n.size() > 0) force += (scene.second_harmonic_n * (turn * turn)).real();
  for (const scene::Pulse& pulse : scene.pulses) {
    const double since_s = turns * scene.period_s() + pulse.elapsed_s;
    if (since_s >= 0 && since_s < pulse.duration_s)
      force += pulse.direction * (pulse.force_n * std::sin(std::numbers::pi * since_s / pulse.duration_s));
  }
  return force;
}

}  // namespace

Energy structure_energy(const scene::Scene& scene, const Eigen::VectorXd& q_m,
                        const Eigen::VectorXd& rate_m_per_s, double turns) {
  const structure::LinearSystem& system = scene.structure;
  const Eigen::VectorXd spring = system.stiffness * q_m, back = system.stiffness.transpose() * q_m;
  Energy energy;
  energy.kinetic_j = rate_m_per_s.dot(system.mass * rate_m_per_s) / 2;
  energy.elastic_j = q_m.dot(spring) / 2;
  energy.damping_w = -rate_m_per_s.dot(system.damping * rate_m_per_s) - rate_m_per_s.dot(spring - back) / 2;
  energy.forcing_w =
      scene.twist ? std::numeric_limits<double>::quiet_NaN() : rate_m_per_s.dot(forcing_n(scene, turns));
  return energy;
}

double spring_energy_j(double stiffness_n_per_m, double penetration_m, double smoothing_m) {
  const double p = penetration_m, half = smoothing_m / 2;
  if (p <= -half) return 0;
  if (p >= half) return stiffness_n_per_m * (p * p / 2 + smoothing_m * smoothing_m / 24);
  return stiffness_n_per_m * (p + half) * (p + half) * (p + half) / (6 * smoothing_m);
}

}  // namespace rubsweep::trace
