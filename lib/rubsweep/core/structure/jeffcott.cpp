#include "rubsweep/core/structure/jeffcott.hpp"

#include <cmath>
#include <complex>
#include <numbers>

namespace rubsweep::structure {

Assembly assemble_jeffcott(const model::JeffcottRotor& rotor,
                           const std::vector<std::optional<model::Casing>>& casings) {
  Eigen::Index n = 2;
  for (const auto& casing : casings) n += casing ? 2 : 0;

  Assembly assembly;
  LinearSystem& system = assembly.system;
  system.mass = system.damping = system.stiffness = Eigen::MatrixXd::Zero(n, n);
  system.unbalance_kg = Eigen::VectorXcd::Zero(n);
  system.weight_kg = Eigen::VectorXd::Zero(n);

  const double omega0 = 2 * std::numbers::pi * rotor.natural_frequency_hz;
  // Multiplied in the order of w^2 M, so that at the natural frequency K - w^2 M is zero to the last bit.
  add_body(system, 0, rotor.mass_kg, omega0 * omega0 * rotor.mass_kg, rotor.damping_ratio);
  if (rotor.rotating_damping_ratio > 0) {
    const double damping = 2 * rotor.rotating_damping_ratio * omega0 * rotor.mass_kg;
    assembly.circulatory = Eigen::MatrixXd::Zero(n, n);
    assembly.circulatory(0, 1) = damping;
    assembly.circulatory(1, 0) = -damping;
    system.damping(0, 0) += damping;
    system.damping(1, 1) += damping;
  }
  system.unbalance_kg(0) = rotor.mass_kg;
  system.unbalance_kg(1) = std::complex<double>(0, -rotor.mass_kg);

  assembly.rotor_points.assign(casings.size(), 0);
  assembly.contact_mass_kg.assign(casings.size(), rotor.mass_kg);
  Eigen::Index next = 2;
  for (const auto& casing : casings) {
    if (!casing) {
      assembly.casing_points.emplace_back();
      continue;
    }
    assembly.casing_points.emplace_back(static_cast<int>(system.points.size()));
    add_body(system, next, casing->mass_kg, casing->stiffness_n_per_m, casing->damping_ratio);
    next += 2;
  }
  return assembly;
}

}  // namespace rubsweep::structure
