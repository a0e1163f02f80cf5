#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

/// A rotor with two discs in modal coordinates, forces of stops and of other causes, and RK4 steps. It shares
/// no code with the library.
namespace two_modes {

using Complex = std::complex<double>;
using std::numbers::pi;

enum class Cause { one_side, two_sides, annular, annular_offset, coupling, whirl, loose };

/// Two equal discs A and B with displacements x + iy. The stops are at A.
struct Rotor {
  double mass_kg = 1, frequency_hz = 0, ratio = 4, damping = 0.02, damping_of_second = 0.02, lean_rad = 0;
  bool two_modes = true;
};

struct Setting {
  Cause cause = Cause::one_side;
  double speed_hz = 0, clearance_m = 3e-4, second_clearance = 1, offset = 0, stiffness = 0, loss = 0,
         friction = 0, radius_m = 0.02, angle_rad = 0, strength = 0;
  Complex unbalance_a, unbalance_b;  ///< mass x eccentricity
};

struct State {
  std::array<Complex, 2> q{}, v{};
};

/// Machine in modal coordinates; the modal mass of both modes is that of a disc.
struct Machine {
  Rotor rotor;
  Setting setting;
  std::array<double, 2> angular{}, at_a{}, at_b{};

  explicit Machine(const Rotor& r, const Setting& s) : rotor(r), setting(s) {
    angular = {2 * pi * r.frequency_hz, 2 * pi * r.frequency_hz * r.ratio};
    at_a = {std::cos(r.lean_rad), r.two_modes ? -std::sin(r.lean_rad) : 0};
    at_b = {std::sin(r.lean_rad), r.two_modes ? std::cos(r.lean_rad) : 0};
  }
  double damping(std::size_t k) const { return k == 0 ? rotor.damping : rotor.damping_of_second; }
  Complex a(const State& s) const { return at_a[0] * s.q[0] + at_a[1] * s.q[1]; }
  Complex b(const State& s) const { return at_b[0] * s.q[0] + at_b[1] * s.q[1]; }

  /// Force of a wall with outward normal n at this penetration: Hunt-Crossley damping and sliding friction.
  Complex wall(Complex n, double depth, Complex velocity) const {
    if (depth <= 0) return 0;
    const double inward = std::real(velocity * std::conj(n));
    const double normal = std::max(0.0, setting.stiffness * depth * (1 + setting.loss * inward));
    const double slip = std::imag(velocity * std::conj(n)) + setting.radius_m * 2 * pi * setting.speed_hz;
    return -normal * n - setting.friction * normal * slip / std::hypot(slip, 1e-2) * n * Complex(0, 1);
  }

  double depth(const State& s) const {
    const Complex z = a(s), n = std::polar(1.0, setting.angle_rad);
    const double along = std::real(z * std::conj(n));
    if (setting.cause == Cause::one_side) return along - setting.clearance_m;
    if (setting.cause == Cause::two_sides)
      return std::max(along - setting.clearance_m, -along - setting.clearance_m * setting.second_clearance);
    if (setting.cause > Cause::annular_offset) return -1;
    return std::abs(z - setting.offset * setting.clearance_m * n) - setting.clearance_m;
  }

  Complex contact(const State& s) const {
    const Complex z = a(s), n = std::polar(1.0, setting.angle_rad);
    const Complex velocity = at_a[0] * s.v[0] + at_a[1] * s.v[1];
    if (setting.cause > Cause::annular_offset) return 0;
    if (setting.cause == Cause::one_side || setting.cause == Cause::two_sides) {
      const double along = std::real(z * std::conj(n));
      Complex force = wall(n, along - setting.clearance_m, velocity);
      if (setting.cause == Cause::two_sides)
        force += wall(-n, -along - setting.clearance_m * setting.second_clearance, velocity);
      return force;
    }
    const Complex from = z - setting.offset * setting.clearance_m * n;
    const double distance = std::abs(from);
    return distance > setting.clearance_m ? wall(from / distance, distance - setting.clearance_m, velocity)
                                          : Complex(0);
  }

  /// Forces at B from causes other than a rub.
  Complex other(const State& s, double t) const {
    const double w = 2 * pi * setting.speed_hz, k = rotor.mass_kg * angular[0] * angular[0];
    const Complex z = b(s);
    switch (setting.cause) {
      case Cause::coupling:
        return k * setting.strength * setting.clearance_m *
               (std::cos(2 * w * t) * std::polar(1.0, setting.angle_rad) + 0.3 * std::cos(3 * w * t));
      case Cause::whirl: {
        // Cross-coupling beyond the stability limit, bounded by damping that grows with the amplitude.
        const Complex velocity = at_b[0] * s.v[0] + at_b[1] * s.v[1];
        const double size = std::abs(z) / setting.clearance_m;
        return Complex(0, -1) * (-k * 2 * rotor.damping * (1.5 + setting.strength)) * z /
                   (at_b[0] * at_b[0]) -
               rotor.mass_kg * angular[0] * 4 * rotor.damping * size * size * velocity / (at_b[0] * at_b[0]);
      }
      case Cause::loose: {
        // A support that is softer in one direction.
        const Complex n = std::polar(1.0, setting.angle_rad);
        const double along = std::real(z * std::conj(n)) + 0.1 * setting.clearance_m;
        return along > 0 ? 0.5 * setting.strength * k * along * n : Complex(0);
      }
      default: return 0;
    }
  }

  State rate(const State& s, double t) const {
    const double w = 2 * pi * setting.speed_hz;
    const Complex turned = std::polar(w * w, w * t), rub = contact(s), cause = other(s, t);
    State d;
    for (std::size_t k = 0; k < 2; ++k) {
      const Complex force =
          at_a[k] * (setting.unbalance_a * turned + rub) + at_b[k] * (setting.unbalance_b * turned + cause);
      d.q[k] = s.v[k];
      d.v[k] =
          force / rotor.mass_kg - 2 * damping(k) * angular[k] * s.v[k] - angular[k] * angular[k] * s.q[k];
    }
    return d;
  }

  Complex quiet_at_a() const {
    const double w = 2 * pi * setting.speed_hz;
    Complex sum = 0;
    for (std::size_t k = 0; k < 2; ++k)
      sum += at_a[k] * (at_a[k] * setting.unbalance_a + at_b[k] * setting.unbalance_b) * w * w /
             (rotor.mass_kg * Complex(angular[k] * angular[k] - w * w, 2 * damping(k) * angular[k] * w));
    return sum;
  }
};

inline State moved(const State& s, const State& d, double h) {
  State next = s;
  for (std::size_t k = 0; k < 2; ++k) {
    next.q[k] += h * d.q[k];
    next.v[k] += h * d.v[k];
  }
  return next;
}

inline State stepped(const Machine& machine, const State& s, double t, double h) {
  const State a = machine.rate(s, t), b = machine.rate(moved(s, a, h / 2), t + h / 2),
              c = machine.rate(moved(s, b, h / 2), t + h / 2), d = machine.rate(moved(s, c, h), t + h);
  State next = s;
  for (std::size_t k = 0; k < 2; ++k) {
    next.q[k] += h / 6 * (a.q[k] + 2.0 * b.q[k] + 2.0 * c.q[k] + d.q[k]);
    next.v[k] += h / 6 * (a.v[k] + 2.0 * b.v[k] + 2.0 * c.v[k] + d.v[k]);
  }
  return next;
}

}  // namespace two_modes
