#pragma once

#include <cmath>
#include <complex>
#include <numbers>

#include "support/simple_scenes.hpp"

namespace rubsweep::test {

/// A rotor of unit mass in a rigid annular stop of unit clearance, in dimensionless time: z'' + 2 zeta z' +
/// stiffness z = e W^2 e^{i W t} + load - k_c (|z| - 1)(1 + i mu) z / |z|, with the contact force only for
/// |z| > 1.
inline scene::Scene annular_scene(double stiffness, double zeta, double speed, double unbalance,
                                  std::complex<double> load, double k_c, double mu) {
  auto scene = one_mass_scene(1, stiffness, 2 * zeta, 2 * std::numbers::pi / speed, 1);
  scene.harmonic_n << unbalance * speed * speed, std::complex<double>(0, -1) * (unbalance * speed * speed);
  scene.constant_n << load.real(), load.imag();
  scene::Contact stop;
  stop.wall = contact::AnnularWall{};
  stop.clearance_m = 1;
  stop.stiffness_n_per_m = k_c;
  if (mu > 0) stop.friction = model::OneWayFriction{mu};
  scene.contacts.push_back(stop);
  return scene;
}

inline void start_at(scene::Scene& scene, std::complex<double> z, std::complex<double> v) {
  scene.displacement_m << z.real(), z.imag();
  scene.velocity_m_per_s << v.real(), v.imag();
}

/// Full annular rub: |(1 + b - W^2) r - b + i (2 zeta W r + mu b (r - 1))| = e W^2, with b = k_c / k.
struct FullRub {
  double zeta = 0.1, speed = 1.2, k_c = 10, mu = 0.05, radius = 1.2;

  std::complex<double> needed() const {
    return {(1 + k_c - speed * speed) * radius - k_c, 2 * zeta * speed * radius + mu * k_c * (radius - 1)};
  }
  scene::Scene scene() const {
    const double unbalance = std::abs(needed()) / (speed * speed);
    auto scene = annular_scene(1, zeta, speed, unbalance, 0, k_c, mu);
    // the rotor lags the unbalance
    const std::complex<double> z = radius * std::polar(1.0, -std::arg(needed()));
    start_at(scene, z, std::complex<double>(0, speed) * z);
    return scene;
  }
};

}  // namespace rubsweep::test
