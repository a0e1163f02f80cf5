#include "rubsweep/core/contact/restitution.hpp"

#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <numbers>
#include <string>

#include "rubsweep/core/error.hpp"

namespace rubsweep::contact {
namespace {

constexpr double largest_damping_ratio = 0.999999;

}  // namespace

double nominal_damping_ratio(double restitution) {
  const double log_e = std::log(restitution);
  return std::abs(log_e) / std::hypot(std::numbers::pi, log_e);
}

double delivered_restitution(double damping_ratio) {
  // Time in units of sqrt(m/K), speed in units of the approach speed.
  const double z = damping_ratio;
  if (z == 0) return 1;
  // Clamped, p'' = -2 p: p = sin(r t)/r, v = cos(r t), r = sqrt 2, until p = 2 z v.
  const double clamp_phase = std::atan(2 * std::numbers::sqrt2 * z);
  const double p1 = std::sin(clamp_phase) / std::numbers::sqrt2;
  const double v1 = std::cos(clamp_phase);
  // Sprung, p'' = -p - 2 z p': the acceleration -(p + 2 z v) is itself a free oscillation
  // e^{-z t} (a cos w t + b sin w t); the piece ends at its first zero.
  const double w = std::sqrt(1 - z * z);
  const double a = -(p1 + 2 * z * v1);
  const double b = (-(v1 + 2 * z * a) + z * a) / w;
  const double phase = std::atan2(-a, b);  // angle in (0, pi) since a < 0
  const double t = phase / w;
  // Speed of p(t) = e^{-z t} (p1 cos w t + (v1 + z p1)/w sin w t).
  const double q = (v1 + z * p1) / w;
  const double speed =
      std::exp(-z * t) * ((w * q - z * p1) * std::cos(phase) - (w * p1 + z * q) * std::sin(phase));
  return -speed;
}

double damping_ratio_delivering(double restitution) {
  if (restitution == 1) return 0;
  const double lowest = delivered_restitution(largest_damping_ratio);
  if (!(restitution > lowest && restitution < 1)) {
    throw ConfigError("restitution_delivered: the clamped contact delivers " + std::to_string(lowest) +
                      " at the least, allowed: a number > " + std::to_string(lowest) + " and <= 1");
  }
  auto excess = [restitution](double zeta) { return delivered_restitution(zeta) - restitution; };
  std::uintmax_t iterations = 100;
  const auto bracket = boost::math::tools::toms748_solve(
      excess, 0.0, largest_damping_ratio, boost::math::tools::eps_tolerance<double>(52), iterations);
  return (bracket.first + bracket.second) / 2;
}

double damping_constant(double damping_ratio, double mass_kg, double stiffness_n_per_m) {
  return 2 * damping_ratio * std::sqrt(mass_kg * stiffness_n_per_m);
}

double reduced_mass(double mass_kg, double casing_mass_kg) {
  return mass_kg * casing_mass_kg / (mass_kg + casing_mass_kg);
}

}  // namespace rubsweep::contact
