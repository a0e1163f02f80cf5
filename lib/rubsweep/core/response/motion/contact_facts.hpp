#pragma once

#include <span>

#include "rubsweep/core/integrate/run/turn.hpp"

namespace rubsweep::response::motion {

/// Contact quantities that the integrator observed over one turn or several.
struct ContactFacts {
  int hits = 0;                    ///< contacts that began
  double contact_fraction = 0;     ///< time in contact / time; 1 with 0 hits is a rotor that slides all along
  double peak_displacement_m = 0;  ///< largest |z|
  double peak_contact_force_n = 0;        ///< largest total force at one stop
  double peak_casing_displacement_m = 0;  ///< largest distance of a casing from its unloaded place
  double peak_twist_rad = 0;              ///< largest angle between rotor and drive
  double peak_torque_nm = 0;              ///< largest torque in the drive
};

/// Facts of one complete turn.
ContactFacts facts_of(const integrate::run::TurnReport& turn);

/// Facts of several turns: hits added up, the mean share of time, the largest peaks.
ContactFacts together(std::span<const ContactFacts> turns);

}  // namespace rubsweep::response::motion
