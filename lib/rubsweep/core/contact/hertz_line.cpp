#include "rubsweep/core/contact/hertz_line.hpp"

#include <cmath>
#include <numbers>

#include "rubsweep/core/error.hpp"

namespace rubsweep::contact {
namespace {

using std::numbers::pi;

double compliance(double youngs_modulus_pa, double poisson_ratio) {
  return (1 - poisson_ratio * poisson_ratio) / youngs_modulus_pa;
}

double both_compliances(const model::HertzLine& contact) {
  return compliance(contact.rotor.youngs_modulus_pa, contact.rotor.poisson_ratio) +
         compliance(contact.casing.youngs_modulus_pa, contact.casing.poisson_ratio);
}

/// Approach divided by 2 F (k0 + k1) / (pi L).
double shape_factor(const model::HertzLine& contact, double force_n) {
  const double slenderness = contact.length_m / (2 * hertz_half_width_m(contact, force_n));
  return 2 * std::numbers::ln2 + 0.5 + std::log(slenderness);
}

}  // namespace

double relative_radius_m(const model::HertzLine& contact) {
  const double rotor = 1 / contact.rotor.radius_m;
  switch (contact.casing_shape) {
    case model::HertzShape::flat: return contact.rotor.radius_m;
    case model::HertzShape::cylinder: return 1 / (rotor + 1 / contact.casing.radius_m);
    case model::HertzShape::hole: return 1 / (rotor - 1 / contact.casing.radius_m);
  }
  return contact.rotor.radius_m;
}

double hertz_half_width_m(const model::HertzLine& contact, double force_n) {
  const double factor = contact.half_width == model::HertzHalfWidth::textbook ? 4 : 2;
  return std::sqrt(factor * force_n * both_compliances(contact) * relative_radius_m(contact) /
                   (pi * contact.length_m));
}

double hertz_approach_m(const model::HertzLine& contact, double force_n) {
  return 2 * force_n * both_compliances(contact) / (pi * contact.length_m) * shape_factor(contact, force_n);
}

double hertz_force_limit_n(const model::HertzLine& contact) {
  const double factor = shape_factor(contact, contact.design_force_n);
  return contact.design_force_n *
         std::exp(2 * factor * hertz_secant_tolerance / (1 + hertz_secant_tolerance));
}

std::optional<double> hertz_secant_n_per_m(const model::HertzLine& contact, double force_n) {
  if (!(contact.length_m >= 2 * hertz_half_width_m(contact, force_n))) return std::nullopt;
  return force_n / hertz_approach_m(contact, force_n);
}

double hertz_stiffness_n_per_m(const model::HertzLine& contact) {
  const auto stiffness = hertz_secant_n_per_m(contact, contact.design_force_n);
  if (!stiffness) {
    throw ConfigError(
        "hertz.design_force_n: the contact is wider than long, allowed: a smaller force or a greater "
        "length_m");
  }
  return *stiffness;
}

}  // namespace rubsweep::contact
