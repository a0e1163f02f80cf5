#pragma once

#include "rubsweep/core/model/machine.hpp"

namespace rubsweep::scene {

/// A soft-mounted rotor under one wall, kicked: `test::OneSideRotor` as a machine of the library.
inline model::Machine one_side_machine() {
  model::Stop stop;
  stop.geometry = model::OneSideGeometry{90};
  stop.clearance_m = 1e-3;
  stop.stiffness_n_per_m = 2e6;
  stop.damping = model::NominalRestitution{0.7};
  stop.contact_radius_m = 0.0375;
  stop.friction = model::StribeckFriction{{0, 0, 0, 0.1, 100, 0}};
  stop.casing = {.mass_kg = 0.05, .stiffness_n_per_m = 5e5, .damping_ratio = 0.1};
  model::Machine machine;
  machine.rotor = model::JeffcottRotor{.mass_kg = 0.8, .natural_frequency_hz = 30, .damping_ratio = 0.02};
  machine.stops = {stop};
  machine.kick = {.force_n = 200, .duration_s = 0.005, .angle_deg = {}};
  return machine;
}

/// The same machine with a second wall on the opposite side; each wall has its own casing.
inline model::Machine both_sides_machine() {
  model::Machine machine = one_side_machine();
  machine.stops.push_back(machine.stops.front());
  machine.stops.back().geometry = model::OneSideGeometry{-90};
  return machine;
}

}  // namespace rubsweep::scene
