#pragma once

#include <algorithm>

namespace rubsweep::contact {

/// Normal force of one contact on the casing, along the outward normal.
struct NormalForce {
  double spring_n = 0;  ///< F_s, the part to which friction is proportional
  double total_n = 0;   ///< F_s + F_d, never negative: a contact does not pull
};

/// Partial derivatives of the normal force with respect to penetration p and closing speed v.
struct ForceSlopes {
  double spring_by_p = 0, total_by_p = 0, total_by_v = 0;
};

/// The clamped ElastoGap law (Modelica.Mechanics.Translational.Components.ElastoGap; Ishibashi & Kawai eq.
/// 1-2, with the clamp that their text mentions and their equations omit). F_s = K p, F_d = clamp(d v, -F_s,
/// F_s) for penetration p > 0, zero otherwise. Continuous in p and v. stiffness [N per unit of p], damping [N
/// per unit of v], both >= 0; v is the closing speed dp/dt.
inline NormalForce elastogap(double stiffness, double damping, double penetration, double closing_speed) {
  if (penetration <= 0) return {};
  const double spring = stiffness * penetration;
  return {spring, spring + std::clamp(damping * closing_speed, -spring, spring)};
}

/// Continuously differentiable max(y, 0): a parabola for |y| < width/2, exact outside.
inline double smooth_ramp(double y, double width) {
  const double half = width / 2;
  if (y <= -half) return 0;
  if (y >= half) return y;
  return (y + half) * (y + half) / (2 * width);
}

/// Derivative of smooth_ramp by y.
inline double smooth_ramp_slope(double y, double width) { return std::clamp(y / width + 0.5, 0.0, 1.0); }

/// The ElastoGap law made continuously differentiable: each corner becomes a parabola over the penetration
/// width `width` (over stiffness * width for the corners of the clamp). Its impulse differs from that of
/// `elastogap` by O(width^2). It never pulls, and is zero below a penetration of -width/2.
inline NormalForce smoothed_elastogap(double stiffness, double damping, double penetration,
                                      double closing_speed, double width) {
  const double force_width = stiffness * width;
  const double spring = stiffness * smooth_ramp(penetration, width);
  const double damper = damping * closing_speed;
  const double clamped =
      damper - smooth_ramp(damper - spring, force_width) + smooth_ramp(-damper - spring, force_width);
  // Rounding may make `clamped` slightly larger than +-spring; with the clamp below, even then the contact
  // does not pull.
  return {spring, spring + std::clamp(clamped, -spring, spring)};
}

/// Partial derivatives of `smoothed_elastogap`.
inline ForceSlopes smoothed_elastogap_slopes(double stiffness, double damping, double penetration,
                                             double closing_speed, double width) {
  const double force_width = stiffness * width;
  const double spring = stiffness * smooth_ramp(penetration, width);
  const double spring_by_p = stiffness * smooth_ramp_slope(penetration, width);
  const double above = smooth_ramp_slope(damping * closing_speed - spring, force_width);
  const double below = smooth_ramp_slope(-damping * closing_speed - spring, force_width);
  return {spring_by_p, spring_by_p * (1 + above - below), damping * (1 - above - below)};
}

}  // namespace rubsweep::contact
