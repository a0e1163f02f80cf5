#pragma once

#include <cmath>

namespace rubsweep::contact {

/// Final speed of a free unit mass that hits a wall of unit stiffness at unit speed: p'' = -force(p, p'),
/// p(0) = p0, p'(0) = 1. Classical Runge-Kutta method in `steps` equal steps up to `duration`. It ignores
/// modes and events, so every corner of the force causes a local error of second order.
double speed_after_impact(const auto& force, double p0, double duration, int steps) {
  const double h = duration / steps;
  double p = p0, v = 1;
  for (int i = 0; i < steps; ++i) {
    const double a1 = -force(p, v);
    const double v2 = v + h / 2 * a1, a2 = -force(p + h / 2 * v, v2);
    const double v3 = v + h / 2 * a2, a3 = -force(p + h / 2 * v2, v3);
    const double v4 = v + h * a3, a4 = -force(p + h * v3, v4);
    p += h / 6 * (v + 2 * v2 + 2 * v3 + v4);
    v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
  return v;
}

}  // namespace rubsweep::contact
