#pragma once

#include <memory>

#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/measurement/diagnose/candidate.hpp"
#include "rubsweep/measurement/diagnose/known_kit.hpp"

namespace rubsweep::diagnose {

/// Numbers of a rotor and its stops that all draws have in common.
struct FixedNumbers {
  double rotor_mass_kg = 1;
  double contact_radius_m = 0.02;
  double casing_damping_ratio = 0.1;
  double rotating_damping_ratio = 0;      ///< rotating damping of a Jeffcott rotor
  std::shared_ptr<const KnownKit> kit{};  ///< kit in place of a Jeffcott rotor; its mass stands above
};

/// Half-sine pulse that starts a drawn machine.
inline constexpr double kick_duration_s = 2e-3;

/// The rotor with the stops of a cause, the first one in the direction of the angle stop_angle. `values` in
/// the units of Unknown; of `no_rub` a stop that nothing reaches stands in for none, as a machine must have
/// one, of a kit where the probes are. The pulse is that of a knock at the stop: a half sine of
/// kick_duration_s whose impulse is rotor mass x kick_ratio x clearance x natural angular frequency.
model::Machine drawn_machine(Cause cause, const Point& values, double clearance_m, const FixedNumbers& fixed);

/// Depth of a contact of this force over the smallest clearance.
double penetration_ratio(Cause cause, const Point& values, double clearance_m, double force_n);

/// Largest one of a rub that a machine survives, unless a study says otherwise.
inline constexpr double usual_penetration_ratio = 0.5;

}  // namespace rubsweep::diagnose
