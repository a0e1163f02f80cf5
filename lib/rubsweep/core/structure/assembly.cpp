#include "rubsweep/core/structure/assembly.hpp"

#include <cmath>
#include <complex>
#include <numbers>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/numerics/dense/factors.hpp"

namespace rubsweep::structure {

void add_body(LinearSystem& system, Eigen::Index first, double mass_kg, double stiffness_n_per_m,
              double damping_ratio) {
  for (Eigen::Index i = first; i < first + 2; ++i) {
    system.mass(i, i) = mass_kg;
    system.stiffness(i, i) = stiffness_n_per_m;
    system.damping(i, i) = 2 * damping_ratio * std::sqrt(stiffness_n_per_m * mass_kg);
  }
  system.weight_kg(first + 1) = -mass_kg;
  Point point{Eigen::Matrix<double, 2, Eigen::Dynamic>::Zero(2, system.coordinates())};
  point.map(0, first) = 1;
  point.map(1, first + 1) = 1;
  system.points.push_back(std::move(point));
}

void refuse_unusable(const Assembly& assembly) {
  const LinearSystem& system = assembly.system;
  bool finite = system.mass.allFinite() && system.damping.allFinite() && system.stiffness.allFinite() &&
                system.unbalance_kg.allFinite() && system.weight_kg.allFinite() &&
                assembly.gyroscopic.allFinite() && assembly.circulatory.allFinite() &&
                assembly.bow_n.allFinite() && assembly.second_n.allFinite() && assembly.static_n.allFinite();
  for (const Point& point : system.points) finite = finite && point.map.allFinite();
  for (const ImpulseTrain& train : assembly.impulses) finite = finite && train.impulse_ns.allFinite();
  if (!finite) {
    throw ConfigError(
        "rotor, stops: their numbers give a mass, damping or stiffness that is no finite number, allowed: "
        "less extreme "
        "ones");
  }
  // Masses are scaled to 1, because a rotor of a tonne may have a casing of a gram.
  const Eigen::VectorXd scale = system.mass.diagonal().cwiseSqrt().cwiseInverse();
  const numerics::dense::CholeskyFactors factor(scale.asDiagonal() * system.mass * scale.asDiagonal());
  if (!scale.allFinite() || !factor.positive_definite()) {
    throw ConfigError(
        "rotor, stops: their numbers leave a motion without mass, allowed: masses less far apart");
  }
}

LinearSystem system_at(const Assembly& assembly, double speed_rad_per_s) {
  LinearSystem system = assembly.system;
  if (assembly.gyroscopic.size() > 0) system.damping += speed_rad_per_s * assembly.gyroscopic;
  if (assembly.circulatory.size() > 0) system.stiffness += speed_rad_per_s * assembly.circulatory;
  for (const TabledSupport& support : assembly.tables)
    add_lacking(support, speed_rad_per_s, system.mass, system.damping, system.stiffness);
  return system;
}

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
  // Factors in the order of w^2 M, so that K - w^2 M is exactly zero at the natural frequency.
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
