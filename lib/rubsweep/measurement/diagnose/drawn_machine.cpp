#include "rubsweep/measurement/diagnose/drawn_machine.hpp"

#include <cmath>
#include <numbers>

namespace rubsweep::diagnose {
namespace {

using std::numbers::pi;

model::Rotor rotor_of(const Point& values, const FixedNumbers& fixed) {
  if (fixed.kit) return likely_kit(*fixed.kit, value_of(values, Unknown::kit));
  return model::JeffcottRotor{fixed.rotor_mass_kg, value_of(values, Unknown::natural_frequency),
                              value_of(values, Unknown::damping_ratio), fixed.rotating_damping_ratio};
}

/// Share of the clearance at which a contact with any exponent has the stiffness `stiffness`.
constexpr double share_of_stiffness = 0.05;

/// Speed that the kick gives the rotor.
double kick_speed_m_per_s(const Point& values, double clearance_m) {
  return value_of(values, Unknown::kick_ratio) * clearance_m * 2 * pi *
         value_of(values, Unknown::natural_frequency);
}

/// Law of a spring (exponent 1), or else a power of the penetration with the damping of Hunt & Crossley. An
/// impact with the speed of the kick has the restitution, slower ones lose less: with the approach speed of
/// each impact, a contact that begins gently and then lasts would be damped without limit.
model::NormalLaw law_of(const Point& values, double clearance_m) {
  model::NormalLaw law;
  const double exponent = value_of(values, Unknown::exponent);
  if (exponent <= 1) return law;
  law.exponent = exponent;
  law.kind = model::ForceCurve::power;
  law.stiffness_n_per_m_n =
      value_of(values, Unknown::stiffness) / std::pow(share_of_stiffness * clearance_m, law.exponent - 1);
  law.damping = model::ImpactDamping::hunt_crossley;
  law.restitution = value_of(values, Unknown::restitution);
  law.approach_speed_m_per_s = kick_speed_m_per_s(values, clearance_m);
  return law;
}

model::Stop stop_of(Cause cause, const Point& values, double clearance_m, const FixedNumbers& fixed) {
  const double mass_kg = value_of(values, Unknown::casing_mass),
               angular = 2 * pi * value_of(values, Unknown::casing_frequency);
  model::Stop stop;
  stop.geometry = model::OneSideGeometry{.angle_deg = value_of(values, Unknown::stop_angle)};
  if (fixed.kit)
    stop.position_m = cause == Cause::no_rub ? fixed.kit->probe_position_m
                                             : place_of_stop(*fixed.kit, value_of(values, Unknown::position));
  stop.clearance_m = clearance_m;
  stop.stiffness_n_per_m = value_of(values, Unknown::stiffness);
  stop.damping = model::NominalRestitution{value_of(values, Unknown::restitution)};
  stop.law = law_of(values, clearance_m);
  stop.contact_radius_m = fixed.contact_radius_m;
  stop.friction = model::ConstantFriction{value_of(values, Unknown::friction)};
  stop.casing = model::Casing{mass_kg, mass_kg * angular * angular, fixed.casing_damping_ratio};
  return stop;
}

model::Kick kick_of(const Point& values, double clearance_m, const FixedNumbers& fixed) {
  model::Kick kick;
  // A half sine of force F has the impulse 2 F duration / pi.
  kick.force_n = fixed.rotor_mass_kg * kick_speed_m_per_s(values, clearance_m) * pi / (2 * kick_duration_s);
  kick.duration_s = kick_duration_s;
  kick.angle_deg = value_of(values, Unknown::stop_angle) + value_of(values, Unknown::kick_angle);
  kick.phase_deg = value_of(values, Unknown::kick_phase);
  return kick;
}

/// Smallest clearance of a machine over that of its first stop.
double smallest_clearance(Cause cause, const Point& values) {
  return cause == Cause::two_sides ? std::fmin(1, value_of(values, Unknown::second_clearance_ratio)) : 1;
}

}  // namespace

model::Machine drawn_machine(Cause cause, const Point& values, double clearance_m,
                             const FixedNumbers& fixed) {
  const double angle_deg = value_of(values, Unknown::stop_angle);
  model::Machine machine;
  machine.rotor = rotor_of(values, fixed);
  model::Stop stop = stop_of(cause, values, clearance_m, fixed);
  if (cause == Cause::annular) stop.geometry = model::AnnularGeometry{};
  if (cause == Cause::annular_offset) {
    const double offset_m = value_of(values, Unknown::offset_ratio) * clearance_m,
                 angle = angle_deg * pi / 180;
    stop.geometry = model::AnnularGeometry{{offset_m * std::cos(angle), offset_m * std::sin(angle)}};
  }
  machine.stops.push_back(stop);
  if (cause == Cause::two_sides) {
    stop.geometry = model::OneSideGeometry{.angle_deg = angle_deg + 180};
    stop.clearance_m *= value_of(values, Unknown::second_clearance_ratio);
    machine.stops.push_back(stop);
  }
  if (cause != Cause::no_rub) machine.kick = kick_of(values, clearance_m, fixed);
  return machine;
}

double penetration_ratio(Cause cause, const Point& values, double clearance_m, double force_n) {
  const double exponent = value_of(values, Unknown::exponent), smallest = smallest_clearance(cause, values),
               stiffness_n_per_m = value_of(values, Unknown::stiffness);
  if (exponent <= 1) return force_n / stiffness_n_per_m / (smallest * clearance_m);
  const double stiff_m = share_of_stiffness * clearance_m;
  return share_of_stiffness * std::pow(force_n / (stiffness_n_per_m * stiff_m), 1 / exponent) / smallest;
}

double force_at_penetration_n(Cause cause, const Point& values, double clearance_m, double ratio) {
  const double exponent = std::fmax(1, value_of(values, Unknown::exponent)),
               stiff_n = value_of(values, Unknown::stiffness) * share_of_stiffness * clearance_m;
  return stiff_n * std::pow(ratio * smallest_clearance(cause, values) / share_of_stiffness, exponent);
}

}  // namespace rubsweep::diagnose
