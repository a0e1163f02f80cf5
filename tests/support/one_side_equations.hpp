#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace rubsweep::test {

/// Jeffcott rotor with one moving wall at 90 degrees: the equations of motion written by hand in SI units,
/// without library code, as an independent check of the solvers. The default values are parameter set A.
struct OneSideRotor {
  double mass_kg = 0.8, natural_frequency_hz = 30, damping_ratio = 0.02;
  double clearance_m = 1e-3, stiffness_n_per_m = 2e6, restitution = 0.7;
  double casing_mass_kg = 0.05, casing_stiffness_n_per_m = 5e5, casing_damping_ratio = 0.1;
  double contact_radius_m = 0.0375, friction_coefficient = 0.1, friction_steepness_s_per_m = 100;
  double kick_n = 200, kick_s = 0.005;
  double speed_hz = 75, whirl_ratio = 0.4;
};

/// Parameter set B: contact fifty times stiffer, on a lighter and stiffer casing.
inline OneSideRotor set_b_rotor() {
  return {.damping_ratio = 0.03,
          .stiffness_n_per_m = 1e8,
          .casing_mass_kg = 0.03,
          .casing_stiffness_n_per_m = 1.18e6,
          .casing_damping_ratio = 0.05,
          .contact_radius_m = 5e-3,
          .kick_n = 120};
}

/// State: x, y, casing x, casing y, and their rates, in m and m/s.
template <class Real>
using OneSideState = std::array<Real, 8>;

/// Smooth pieces of the force law; `by_state`: the state alone decides which one holds.
enum class Piece { by_state, open, clamped, sprung, released };

template <class Real>
struct OneSideEquations {
  Real m, k, c, mc, kc, cc, contact_k, d, clearance, omega, kick, kick_rate, kick_s, surface_speed, mu,
      steepness;
  Real whirl, force_x_cos, force_x_sin;  // unbalance force: x: X cos + Y sin; y: X sin - Y cos
  Piece piece = Piece::by_state;

  explicit OneSideEquations(const OneSideRotor& p) {
    const Real pi = std::numbers::pi_v<Real>;
    m = p.mass_kg;
    const Real w0 = 2 * pi * Real(p.natural_frequency_hz);
    k = m * w0 * w0;
    c = 2 * Real(p.damping_ratio) * m * w0;
    mc = p.casing_mass_kg;
    kc = p.casing_stiffness_n_per_m;
    cc = 2 * Real(p.casing_damping_ratio) * std::sqrt(mc * kc);
    contact_k = p.stiffness_n_per_m;
    const Real log_e = std::log(Real(p.restitution));
    d = 2 * std::sqrt(log_e * log_e / (pi * pi + log_e * log_e)) * std::sqrt(contact_k * m * mc / (m + mc));
    clearance = p.clearance_m;
    omega = 2 * pi * Real(p.speed_hz);
    kick = p.kick_n;
    kick_s = p.kick_s;
    kick_rate = pi / kick_s;
    surface_speed = Real(p.contact_radius_m) * omega;
    mu = p.friction_coefficient;
    steepness = p.friction_steepness_s_per_m;
    // z = i A e^{i w t} solves m z'' + c z' + k z = F e^{i w t} with F = i A (k - m w^2 + i c w).
    whirl = Real(p.whirl_ratio) * clearance;
    force_x_cos = -whirl * c * omega;
    force_x_sin = -whirl * (k - m * omega * omega);
  }

  OneSideState<Real> start() const { return {0, whirl, 0, 0, -whirl * omega, 0, 0, 0}; }

  Real penetration(const OneSideState<Real>& s) const { return s[1] - s[3] - clearance; }
  Real closing_speed(const OneSideState<Real>& s) const { return s[5] - s[7]; }

  Piece piece_of(const OneSideState<Real>& s) const {
    const Real spring = contact_k * penetration(s), damper = d * closing_speed(s);
    if (spring <= 0) return Piece::open;
    if (damper >= spring) return Piece::clamped;
    return damper <= -spring ? Piece::released : Piece::sprung;
  }

  void operator()(const OneSideState<Real>& s, OneSideState<Real>& rate, Real t) const {
    const Piece now = piece == Piece::by_state ? piece_of(s) : piece;
    const Real spring = now == Piece::open ? 0 : contact_k * penetration(s);
    Real normal = 0;
    if (now == Piece::clamped) normal = 2 * spring;
    if (now == Piece::sprung) normal = spring + d * closing_speed(s);
    // the tangent of a wall at 90 degrees is (-1, 0)
    const Real slip = -(s[4] - s[6]) + surface_speed;
    const Real friction = spring == 0 ? 0 : mu * std::tanh(steepness * slip) * spring;
    const Real cosine = std::cos(omega * t), sine = std::sin(omega * t);
    const Real pulse = t < kick_s ? kick * std::sin(kick_rate * t) : 0;
    for (std::size_t i = 0; i < 4; ++i) rate[i] = s[i + 4];
    rate[4] = (-k * s[0] - c * s[4] + force_x_cos * cosine + force_x_sin * sine + friction) / m;
    rate[5] = (-k * s[1] - c * s[5] + force_x_cos * sine - force_x_sin * cosine + pulse - normal) / m;
    rate[6] = (-kc * s[2] - cc * s[6] - friction) / mc;
    rate[7] = (-kc * s[3] - cc * s[7] + normal) / mc;
  }
};

}  // namespace rubsweep::test
