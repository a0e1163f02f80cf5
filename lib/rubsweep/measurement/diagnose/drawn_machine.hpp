#pragma once

#include <memory>

#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/measurement/diagnose/candidate.hpp"
#include "rubsweep/measurement/diagnose/known_kit.hpp"

namespace rubsweep::diagnose {

/// Parameters of rotor and stops that are the same in all draws.
struct FixedNumbers {
  double rotor_mass_kg = 1;
  double contact_radius_m = 0.02;
  double casing_damping_ratio = 0.1;
  double rotating_damping_ratio = 0;      ///< rotating damping of a Jeffcott rotor
  std::shared_ptr<const KnownKit> kit{};  ///< kit in place of a Jeffcott rotor; its mass is rotor_mass_kg
};

inline constexpr double kick_duration_s = 2e-3;  ///< Duration of the pulse that starts a drawn machine.

/// The rotor with the stops of a cause; the first stop lies in the direction stop_angle. `values` has the
/// units of Unknown. Since a machine must have a stop, `no_rub` has one out of reach, in a kit at the probes.
/// The pulse is a knock at the stop: a half sine of kick_duration_s with the impulse rotor mass x kick_ratio
/// x clearance x natural angular frequency.
model::Machine drawn_machine(Cause cause, const Point& values, double clearance_m, const FixedNumbers& fixed);

/// Penetration at this contact force divided by the smallest clearance; the second function inverts it.
double penetration_ratio(Cause cause, const Point& values, double clearance_m, double force_n);
double force_at_penetration_n(Cause cause, const Point& values, double clearance_m, double ratio);

/// Largest penetration ratio that a machine survives, unless a study gives another one.
inline constexpr double usual_penetration_ratio = 0.5;

}  // namespace rubsweep::diagnose
