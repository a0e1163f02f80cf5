#pragma once

#include "core/scene/one_side_machine.hpp"
#include "rubsweep/core/scene/build_scene.hpp"

namespace rubsweep::response::testing {

/// A rotor with well-damped mounts in an annular stop (parameter set C): circular motion at low speed; at
/// high speed ovals that rotate relative to the shaft.
inline model::Machine annular_machine(double offset_y_m = 0) {
  model::Machine machine = scene::one_side_machine();
  model::Stop& stop = machine.stops[0];
  stop.geometry = model::AnnularGeometry{{0, offset_y_m}};
  stop.damping = model::NominalRestitution{0.5};
  stop.friction = model::StribeckFriction{{0, 0, 0, 0.02, 100, 0}};
  stop.casing->damping_ratio = 1;
  std::get<model::JeffcottRotor>(machine.rotor).damping_ratio = 0.04;
  machine.kick->force_n = 150;
  return machine;
}

inline scene::Cell annular_cell(double speed_hz, double whirl_ratio, double offset_y_m = 0) {
  return scene::build_cell(annular_machine(offset_y_m), speed_hz, scene::WhirlRatio{whirl_ratio});
}

}  // namespace rubsweep::response::testing
