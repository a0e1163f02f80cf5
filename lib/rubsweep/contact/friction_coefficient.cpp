#include "rubsweep/contact/friction_coefficient.hpp"

#include <cmath>

namespace rubsweep::contact {
namespace {

/// tanh(x), skipping the library call where the result is 1 to the last bit.
double saturating_tanh(double x) {
  constexpr double saturated_above = 20;  // 1 - tanh(20) = 8.5e-18 < epsilon/2
  return std::abs(x) > saturated_above ? std::copysign(1.0, x) : std::tanh(x);
}

/// Derivative of tanh(g v) by v: g sech^2(g v).
double tanh_slope(double g, double v) {
  const double t = saturating_tanh(g * v);
  return g * (1 - t * t);
}

}  // namespace

double friction_coefficient(const model::Friction& friction, double slip_m_per_s) {
  if (const auto* stribeck = std::get_if<model::StribeckFriction>(&friction)) {
    const auto& g = stribeck->gamma;
    double mu = g[3] * saturating_tanh(g[4] * slip_m_per_s) + g[5] * slip_m_per_s;
    if (g[0] != 0) mu += g[0] * (saturating_tanh(g[1] * slip_m_per_s) - saturating_tanh(g[2] * slip_m_per_s));
    return mu;
  }
  if (const auto* constant = std::get_if<model::ConstantFriction>(&friction)) return constant->coefficient;
  return 0;
}

double friction_slope(const model::Friction& friction, double slip_m_per_s) {
  const auto* stribeck = std::get_if<model::StribeckFriction>(&friction);
  if (stribeck == nullptr) return 0;
  const auto& g = stribeck->gamma;
  double slope = g[3] * tanh_slope(g[4], slip_m_per_s) + g[5];
  if (g[0] != 0) slope += g[0] * (tanh_slope(g[1], slip_m_per_s) - tanh_slope(g[2], slip_m_per_s));
  return slope;
}

}  // namespace rubsweep::contact
