// The equations of machines with nonlinear contacts, written again in long double. Only the numbers of a
// scene come from the library.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "rubsweep/core/model/stop.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::integrate::test_curved {

using model::ForceCurve;
using model::ImpactDamping;
using Real = long double;

/// A line contact of Hertz, written again.
struct LineContact {
  explicit LineContact(const model::HertzLine& h) : length_m(h.length_m), radius_m(h.rotor.radius_m) {
    const auto soft = [](const model::HertzBody& body) {
      return (1 - Real(body.poisson_ratio) * body.poisson_ratio) / body.youngs_modulus_pa;
    };
    both = soft(h.rotor) + soft(h.casing);
    widest_n = pi * length_m * length_m * length_m / (16 * both * radius_m);
    widest_m = widest_n * both / (pi * length_m) * (log_16 + 1);
  }

  /// Beyond the force under which the contact is as wide as long, the law is the tangent there.
  Real force_n(Real p) const {
    if (p >= widest_m) return widest_n + (p - widest_m) * pi * length_m / (both * log_16);
    Real force = std::min(p / both, widest_n);
    for (int k = 0; k < 40; ++k) {
      const Real b = std::sqrt(4 * force * both * radius_m / (pi * length_m));
      force = p * pi * length_m / (2 * both * (log_16 / 2 + 0.5L + std::log(length_m / (2 * b))));
    }
    return force;
  }

  static constexpr Real pi = std::numbers::pi_v<Real>, log_16 = 4 * std::numbers::ln2_v<Real>;
  Real length_m, radius_m, both, widest_n, widest_m;
};

/// Elastic force of a stop, written again.
inline Real spring(const model::Stop& stop, Real p) {
  const model::NormalLaw& law = stop.law;
  if (p <= 0) return 0;
  if (law.kind == ForceCurve::power) return law.stiffness_n_per_m_n * std::pow(p, Real(law.exponent));
  if (law.kind == ForceCurve::hertz_line) return LineContact(*stop.hertz).force_n(p);
  // Hermite's cubics with slopes by Fritsch and Butland; three points.
  const auto& x = law.penetration_m;
  const auto& y = law.force_n;
  const Real h0 = Real(x[1]) - x[0], h1 = Real(x[2]) - x[1], d0 = (Real(y[1]) - y[0]) / h0,
             d1 = (Real(y[2]) - y[1]) / h1;
  const Real w0 = 2 * h1 + h0, w1 = h1 + 2 * h0;
  const auto end = [](Real h, Real next, Real d, Real other) {
    const Real slope = ((2 * h + next) * d - h * other) / (h + next);
    return slope <= 0 ? 0 : slope;
  };
  const Real slopes[] = {end(h0, h1, d0, d1), (w0 + w1) / (w0 / d0 + w1 / d1), end(h1, h0, d1, d0)};
  if (p >= x[2]) return y[2] + slopes[2] * (p - x[2]);
  const int k = p < x[1] ? 0 : 1;
  const Real h = k == 0 ? h0 : h1, t = (p - x[std::size_t(k)]) / h, u = 1 - t;
  return u * u * (1 + 2 * t) * y[std::size_t(k)] + t * t * (3 - 2 * t) * y[std::size_t(k) + 1] +
         h * t * u * (u * slopes[k] - t * slopes[k + 1]);
}

using Numbers = std::array<Real, 8>;

/// Integrates a scene of `rotor_and_casing` independently of the library, in SI units and long double, with
/// the classical Runge-Kutta method. Steps are shorter in contact, and end where a contact begins, ends or no
/// longer presses.
struct Reference {
  const scene::Scene& scene;
  std::vector<model::Stop> stops;
  std::vector<Real> x{};      ///< c v0 of each stop
  std::vector<Real> speed{};  ///< speed of the present approach
  Numbers state{};
  Real longest = 1;
  /// Direction of the slip of the only contact with dry friction: 1, -1, or 0 while it sticks.
  int way = 1;

  bool dry(std::size_t i) const {
    return std::holds_alternative<model::ConstantFriction>(scene.contacts[i].friction);
  }

  struct Seen {
    Real p, v, s, nx, ny, turning;  ///< turning: of the normal, over the sliding speed
  };
  Seen seen(std::size_t i, const Numbers& z) const {
    const scene::Contact& c = scene.contacts[i];
    const Real moves = c.casing_point ? 1 : 0;
    const Real dx = z[0] - moves * z[2], dy = z[1] - moves * z[3], vx = z[4] - moves * z[6],
               vy = z[5] - moves * z[7];
    Real nx = 0, ny = 0, turning = 0;
    if (const auto* flat = std::get_if<contact::FlatWall>(&c.wall)) {
      nx = flat->normal.x(), ny = flat->normal.y();
    } else {
      const Real r = std::hypot(dx, dy);
      nx = r > 0 ? dx / r : 1, ny = r > 0 ? dy / r : 0, turning = r > 0 ? 1 / r : 0;
    }
    return {dx * nx + dy * ny - c.clearance_m, vx * nx + vy * ny, vy * nx - vx * ny, nx, ny, turning};
  }

  Real slip(std::size_t i, const Numbers& z) const {
    return seen(i, z).s + scene.contacts[i].surface_speed_m_per_s;
  }
  Real slip_rate(std::size_t i, const Numbers& z, Real t, Real share) const {
    const Numbers by = rate_with(z, t, share);
    const Seen m = seen(i, z);
    const Real moves = scene.contacts[i].casing_point ? 1 : 0;
    return (by[5] - moves * by[7]) * m.nx - (by[4] - moves * by[6]) * m.ny - m.v * m.s * m.turning;
  }
  /// Share of the bound with which dry friction holds contact `i`.
  Real holding_share(std::size_t i, const Numbers& z, Real t) const {
    const Real forward = slip_rate(i, z, t, 1), backward = slip_rate(i, z, t, -1);
    return (backward + forward) / (backward - forward);
  }

  Numbers rate(const Numbers& z, Real t) const {
    Real share = way;
    if (way == 0)
      for (std::size_t i = 0; i < stops.size(); ++i)
        if (dry(i)) share = holding_share(i, z, t);
    return rate_with(z, t, share);
  }

  Numbers rate_with(const Numbers& z, Real t, Real share) const {
    const Real w = scene.speed_rad_per_s;
    std::array<Real, 4> force{};
    for (int i = 0; i < 4; ++i)
      force[std::size_t(i)] = Real(scene.constant_n(i)) + Real(scene.harmonic_n(i).real()) * std::cos(w * t) -
                              Real(scene.harmonic_n(i).imag()) * std::sin(w * t) -
                              Real(scene.structure.stiffness(i, i)) * z[std::size_t(i)] -
                              Real(scene.structure.damping(i, i)) * z[std::size_t(i) + 4];
    for (std::size_t i = 0; i < stops.size(); ++i) {
      const Seen m = seen(i, z);
      const Real elastic = spring(stops[i], m.p);
      const Real normal = elastic * std::max<Real>(0, 1 + x[i] * m.v / speed[i]);
      Real mu = 0;
      const Real slip = m.s + scene.contacts[i].surface_speed_m_per_s;
      if (const auto* dry = std::get_if<model::ConstantFriction>(&scene.contacts[i].friction))
        mu = dry->coefficient * share;
      if (const auto* curve = std::get_if<model::StribeckFriction>(&scene.contacts[i].friction))
        mu = curve->gamma[3] * std::tanh(curve->gamma[4] * slip);
      const Real fx = normal * m.nx - mu * elastic * m.ny, fy = normal * m.ny + mu * elastic * m.nx;
      force[0] -= fx, force[1] -= fy;
      if (scene.contacts[i].casing_point) force[2] += fx, force[3] += fy;
    }
    Numbers out{};
    for (std::size_t i = 0; i < 4; ++i) {
      out[i] = z[i + 4];
      out[i + 4] = force[i] / Real(scene.structure.mass(Eigen::Index(i), Eigen::Index(i)));
    }
    return out;
  }

  /// Number of points below a penetration where the slope of the force bends.
  static long piece(const model::Stop& stop, Real p) {
    if (stop.law.kind == ForceCurve::hertz_line) return p > LineContact(*stop.hertz).widest_m ? 1 : 0;
    if (stop.law.kind != ForceCurve::table) return 0;
    return std::ranges::count_if(stop.law.penetration_m, [p](double at) { return p > at; });
  }

  Numbers step(Real t, Real h) const {
    const auto at = [&](const Numbers& k, Real f) {
      Numbers z = state;
      for (std::size_t i = 0; i < 8; ++i) z[i] += f * k[i];
      return z;
    };
    const auto a = rate(state, t), b = rate(at(a, h / 2), t + h / 2), c = rate(at(b, h / 2), t + h / 2),
               d = rate(at(c, h), t + h);
    Numbers z = state;
    for (std::size_t i = 0; i < 8; ++i) z[i] += h / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
    return z;
  }

  /// Direction of slip of contact `i` after an instant at which it began to touch, stopped or let go.
  void settle_way(std::size_t i, const Numbers& z, Real t, bool began) {
    const Real slips = slip(i, z);
    if (began) {
      way = slips > 0 ? 1 : -1;
    } else if (way == 0) {
      const Real share = holding_share(i, z, t);
      if (std::abs(share) > 1) way = share > 0 ? 1 : -1;
    } else if (slips * Real(way) <= 0) {
      way = slip_rate(i, z, t, 1) > 0 ? 1 : slip_rate(i, z, t, -1) < 0 ? -1 : 0;
    }
  }

  /// Takes the slip of contact `i`, which the errors of many steps have made, from the speeds of `z` by an
  /// impulse of friction.
  void hold(std::size_t i, Numbers& z) const {
    const Seen m = seen(i, z);
    const std::array<Real, 4> along{-m.ny, m.nx, m.ny, -m.nx};
    const std::size_t moving = scene.contacts[i].casing_point ? 4 : 2;
    const auto mass = [&](std::size_t k) {
      return Real(scene.structure.mass(Eigen::Index(k), Eigen::Index(k)));
    };
    Real mobility = 0;
    for (std::size_t k = 0; k < moving; ++k) mobility += along[k] * along[k] / mass(k);
    const Real impulse = slip(i, z) / mobility;
    for (std::size_t k = 0; k < moving; ++k) z[k + 4] -= impulse * along[k] / mass(k);
  }

  /// One step, shortened to the first instant at which a contact begins, ends, no longer presses, turns
  /// back, stops slipping, lets go or passes a point of a measured curve. Without the turns a touch and the
  /// flight after it, or a short flight between two touches, could lie within a step.
  Real advance(Real t, Real most) {
    const Real w = scene.speed_rad_per_s;
    Real h = most;
    for (std::size_t i = 0; i < stops.size(); ++i) {
      const Seen m = seen(i, state);
      if (m.p <= 0) continue;
      h = std::min(h, std::clamp(m.p / (100 * std::abs(m.v)), 1e-7L / w, longest / (4 * w)));
      // Shorter than the contact's vibration; if a grazing impact set the damping, the damper is stiff.
      const Real elastic = spring(stops[i], m.p);
      h = std::min(h, Real(0.001L) * std::sqrt(m.p / elastic));
      h = std::min(h, speed[i] * Real(0.005L) / (x[i] * elastic + 1e-9L));
    }
    h = std::min(h, longest / w);
    Numbers next = step(t, h);
    // Rising or falling; open, pressing or no longer pressing; whether dry friction goes on as it does; and
    // the piece of the curve.
    const auto region = [&](std::size_t i, const Numbers& z, Real at) {
      const Seen m = seen(i, z);
      const bool goes_on = m.p <= 0 || !dry(i) ||
                           (way == 0 ? std::abs(holding_share(i, z, at)) <= 1 : slip(i, z) * Real(way) > 0);
      const int presses = 1 + x[i] * m.v / speed[i] > 0 ? 1 : 2;
      return std::tuple(m.v > 0, m.p <= 0 ? 0 : presses, goes_on, piece(stops[i], m.p));
    };
    const auto changed_at = [&](const Numbers& z, Real at) {
      for (std::size_t i = 0; i < stops.size(); ++i)
        if (region(i, z, at) != region(i, state, t)) return true;
      return false;
    };
    const auto changed = [&](Real after) { return changed_at(step(t, after), t + after); };
    if (changed_at(next, t + h)) {
      Real low = 0, high = h;
      for (int k = 0; k < 70; ++k) {
        const Real middle = (low + high) / 2;
        (changed(middle) ? high : low) = middle;
      }
      h = high;
      next = step(t, h);
    }
    for (std::size_t i = 0; i < stops.size(); ++i) {
      const bool began = seen(i, state).p <= 0 && seen(i, next).p > 0;
      if (began && !stops[i].law.approach_speed_m_per_s)
        speed[i] = std::max(seen(i, next).v, Real(1e-3) * scene.contacts[i].clearance_m * w);
      if (!dry(i) || seen(i, next).p <= 0) continue;
      settle_way(i, next, t + h, began);
      if (way == 0) hold(i, next);
    }
    state = next;
    return t + h;
  }

  std::vector<double> after_turns(int turns) {
    const Real period = 2 * std::numbers::pi_v<Real> / scene.speed_rad_per_s, end = turns * period;
    for (Real t = 0; t < end;) t = advance(t, end - t);
    std::vector<double> section(8);
    for (std::size_t i = 0; i < 8; ++i)
      section[i] = double(state[i] / (1e-3L * (i < 4 ? 1 : Real(scene.speed_rad_per_s))));
    return section;
  }
};

}  // namespace rubsweep::integrate::test_curved
