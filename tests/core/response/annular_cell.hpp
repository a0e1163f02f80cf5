#pragma once

#include "rubsweep/core/scene/build_scene.hpp"

namespace rubsweep::response::testing {

/// A rotor in an annular stop with well-damped mounts (parameter set C): circles at low speed, at high speed
/// ovals that turn against the shaft's frame.
inline model::Machine annular_machine(double offset_y_m = 0) {
  model::Stop stop;
  stop.geometry = model::AnnularGeometry{{0, offset_y_m}};
  stop.clearance_m = 1e-3;
  stop.stiffness_n_per_m = 2e6;
  stop.damping = model::NominalRestitution{0.5};
  stop.contact_radius_m = 0.0375;
  stop.friction = model::StribeckFriction{{0, 0, 0, 0.02, 100, 0}};
  stop.casing = {.mass_kg = 0.05, .stiffness_n_per_m = 5e5, .damping_ratio = 1};
  model::Machine machine;
  machine.rotor = model::JeffcottRotor{.mass_kg = 0.8, .natural_frequency_hz = 30, .damping_ratio = 0.04};
  machine.stops = {stop};
  machine.kick = {.force_n = 150, .duration_s = 0.005, .angle_deg = {}};
  return machine;
}

inline scene::Cell annular_cell(double speed_hz, double whirl_ratio, double offset_y_m = 0) {
  return scene::build_cell(annular_machine(offset_y_m), speed_hz, scene::WhirlRatio{whirl_ratio});
}

}  // namespace rubsweep::response::testing
