#include "rubsweep/core/contact/friction_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "rubsweep/core/overloaded.hpp"

namespace rubsweep::contact {
namespace {

using model::ConstantFriction;
using model::FallingFriction;
using model::NoFriction;
using model::OneWayFriction;
using model::StaticFriction;
using model::StribeckFriction;

constexpr double everywhere = -std::numeric_limits<double>::infinity();

/// Value of tanh(x); skips the library call where the result is 1 to the last bit.
double saturating_tanh(double x) {
  constexpr double saturated_above = 20;  // 1 - tanh(20) = 8.5e-18 < epsilon/2
  return std::abs(x) > saturated_above ? std::copysign(1.0, x) : std::tanh(x);
}

/// Derivative of tanh(g v) by v: g sech^2(g v).
double tanh_slope(double g, double v) {
  const double t = saturating_tanh(g * v);
  return g * (1 - t * t);
}

double reversing(double coefficient, double slip_m_per_s) {
  return slip_m_per_s == 0 ? 0.0 : std::copysign(coefficient, slip_m_per_s);
}

double coefficient_of(const StribeckFriction& stribeck, double v) {
  const auto& g = stribeck.gamma;
  double mu = g[3] * saturating_tanh(g[4] * v) + g[5] * v;
  if (g[0] != 0) mu += g[0] * (saturating_tanh(g[1] * v) - saturating_tanh(g[2] * v));
  return mu;
}

double slope_of(const StribeckFriction& stribeck, double v) {
  const auto& g = stribeck.gamma;
  double slope = g[3] * tanh_slope(g[4], v) + g[5];
  if (g[0] != 0) slope += g[0] * (tanh_slope(g[1], v) - tanh_slope(g[2], v));
  return slope;
}

using Saturated = std::optional<SaturatedFriction>;

Saturated saturated(const NoFriction&) { return SaturatedFriction{0, everywhere}; }
Saturated saturated(const OneWayFriction& law) { return SaturatedFriction{law.coefficient, everywhere}; }
Saturated saturated(const ConstantFriction& law) {
  return SaturatedFriction{law.coefficient, law.coefficient == 0 ? everywhere : 0};
}
Saturated saturated(const StaticFriction& law) {
  return SaturatedFriction{law.coefficient, law.static_coefficient == 0 ? everywhere : 0};
}

Saturated saturated(const StribeckFriction& stribeck) {
  constexpr double saturated_argument = 14;  // 1 - tanh(14) = 1.4e-12
  const auto& g = stribeck.gamma;
  if (g[5] != 0) return std::nullopt;
  double steepness = std::numeric_limits<double>::infinity();
  if (g[0] != 0) steepness = std::min(g[1], g[2]);
  if (g[3] != 0) steepness = std::min(steepness, g[4]);
  if (!(steepness > 0)) return std::nullopt;
  return SaturatedFriction{g[3], saturated_argument / steepness};
}

/// Sliding friction in its own direction. It holds from the slip speed at which the falling part has decayed
/// to exp(-28).
Saturated saturated(const FallingFriction& law) {
  constexpr double saturated_argument = 28;  // exp(-28) = 7e-13, as small as 1 - tanh(14)
  const double steep = law.exponent == 1 ? saturated_argument : std::sqrt(saturated_argument);
  return SaturatedFriction{law.coefficient, steep * law.stribeck_speed_m_per_s};
}

FrictionTerms holding_terms(double holding, double dry) {
  FrictionTerms terms;
  terms.holding = holding;
  terms.dry = dry;
  return terms;
}

FrictionTerms terms_of(const NoFriction&) { return {}; }
FrictionTerms terms_of(const ConstantFriction& law) {
  return holding_terms(law.coefficient, law.coefficient);
}
FrictionTerms terms_of(const StaticFriction& law) {
  return holding_terms(law.static_coefficient, law.coefficient);
}
FrictionTerms terms_of(const OneWayFriction& law) {
  FrictionTerms terms;
  terms.constant = law.coefficient;
  return terms;
}
FrictionTerms terms_of(const FallingFriction& law) {
  FrictionTerms terms = holding_terms(law.static_coefficient, law.coefficient);
  terms.falling = {law.static_coefficient - law.coefficient, 1 / law.stribeck_speed_m_per_s, law.exponent};
  return terms;
}

void add(FrictionTerms& terms, double height, double steepness_s_per_m) {
  if (height == 0 || steepness_s_per_m == 0) return;
  for (std::size_t i = 0; i < terms.count; ++i) {
    if (terms.tanh[i].steepness_s_per_m != steepness_s_per_m) continue;
    terms.tanh[i].height += height;
    return;
  }
  terms.tanh[terms.count++] = {height, steepness_s_per_m};
}

FrictionTerms terms_of(const StribeckFriction& stribeck) {
  const auto& g = stribeck.gamma;
  FrictionTerms terms;
  terms.viscous_s_per_m = g[5];
  add(terms, g[3], g[4]);
  add(terms, g[0], g[1]);
  add(terms, -g[0], g[2]);
  return terms;
}

}  // namespace

double Falling::at(double slip_m_per_s) const {
  const double x = steepness_s_per_m * slip_m_per_s;
  return height == 0 ? 0 : height * std::exp(exponent == 1 ? -x : -x * x);
}

double Falling::slope(double slip_m_per_s) const {
  return at(slip_m_per_s) * -steepness_s_per_m * (exponent == 1 ? 1 : 2 * steepness_s_per_m * slip_m_per_s);
}

double friction_coefficient(const model::Friction& friction, double slip_m_per_s) {
  return std::visit(
      overloaded{
          [](const NoFriction&) { return 0.0; },
          [&](const ConstantFriction& constant) { return reversing(constant.coefficient, slip_m_per_s); },
          [](const OneWayFriction& one_way) { return one_way.coefficient; },
          [&](const StribeckFriction& stribeck) { return coefficient_of(stribeck, slip_m_per_s); },
          [&](const StaticFriction& law) { return reversing(law.coefficient, slip_m_per_s); },
          [&](const FallingFriction& law) {
            const double falling = terms_of(law).falling.at(std::abs(slip_m_per_s));
            return reversing(law.coefficient + falling, slip_m_per_s);
          }},
      friction);
}

double friction_slope(const model::Friction& friction, double slip_m_per_s) {
  return std::visit(
      overloaded{
          [](const NoFriction&) { return 0.0; }, [](const ConstantFriction&) { return 0.0; },
          [](const OneWayFriction&) { return 0.0; },
          [&](const StribeckFriction& stribeck) { return slope_of(stribeck, slip_m_per_s); },
          [](const StaticFriction&) { return 0.0; },
          [&](const FallingFriction& law) { return terms_of(law).falling.slope(std::abs(slip_m_per_s)); }},
      friction);
}

std::optional<SaturatedFriction> saturated_friction(const model::Friction& friction) {
  return std::visit([](const auto& law) { return saturated(law); }, friction);
}

FrictionTerms friction_terms(const model::Friction& friction) {
  return std::visit([](const auto& law) { return terms_of(law); }, friction);
}

bool acts(const model::Friction& friction) { return !std::holds_alternative<NoFriction>(friction); }

bool depends_on_slip(const model::Friction& friction) {
  return std::visit(
      overloaded{[](const NoFriction&) { return false; }, [](const ConstantFriction&) { return false; },
                 [](const OneWayFriction&) { return false; }, [](const StribeckFriction&) { return true; },
                 [](const StaticFriction&) { return false; }, [](const FallingFriction&) { return true; }},
      friction);
}

bool keeps_its_direction(const model::Friction& friction) { return friction_terms(friction).constant != 0; }

double dry_coefficient(const model::Friction& friction) { return friction_terms(friction).dry; }

double holding_coefficient(const model::Friction& friction) { return friction_terms(friction).holding; }

std::string_view name_of(const model::Friction& friction) {
  return std::visit([](const auto& law) { return law.name; }, friction);
}

}  // namespace rubsweep::contact
