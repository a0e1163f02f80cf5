#pragma once

#include <cmath>
#include <complex>
#include <numbers>

#include "support/simple_scenes.hpp"

namespace rubsweep::test {

/// Backward rolling in a rigid annular stop, started on its closed form. Friction balances damping, and the
/// tanh law allows a small slip: z = r e^{-i w t} with (1 + b - w^2) r = b, mu b (r - 1) = 2 zeta w r and the
/// slip R W - r w = atanh(mu / limit) / steepness (b: contact over shaft stiffness; units of the mass, the
/// shaft's spring and the annular stop; a revolution lasts 2 pi). The motion is attracting: a faster whirl
/// slips less.
struct RollingScene {
  scene::Scene scene;
  double radius = 0, whirl = 0;

  std::complex<double> displacement(double revolutions) const {
    return std::polar(radius, -whirl * 2 * std::numbers::pi * revolutions);
  }
  std::complex<double> velocity(double revolutions) const {
    return std::complex<double>(0, -whirl) * displacement(revolutions);
  }
};

/// `steepness_s_per_m`: gamma5 of the tanh law.
inline RollingScene rolling_scene(double steepness_s_per_m) {
  const double zeta = 0.04, b = 76, whirl = 1.5, limit = 0.2;
  const double radius = b / (1 + b - whirl * whirl), mu = 2 * zeta * whirl * radius / (b * (radius - 1));
  RollingScene rolling{one_mass_scene(1, 1, 2 * zeta, 2 * std::numbers::pi, 1), radius, whirl};
  scene::Contact stop;
  stop.wall = contact::AnnularWall{};
  stop.clearance_m = 1;
  stop.stiffness_n_per_m = b;
  stop.friction = model::StribeckFriction{{0, 0, 0, limit, steepness_s_per_m, 0}};
  stop.surface_speed_m_per_s = radius * whirl + std::atanh(mu / limit) / steepness_s_per_m;
  rolling.scene.contacts.push_back(stop);
  rolling.scene.displacement_m << radius, 0;
  rolling.scene.velocity_m_per_s << 0, -whirl * radius;
  return rolling;
}

}  // namespace rubsweep::test
