#pragma once

#include <cmath>
#include <numbers>

#include "core/scene/one_side_machine.hpp"

namespace rubsweep::ramp {

/// A rotor of 30 Hz inside an elastic ring four times stiffer than its shaft, without friction and contact
/// damping.
inline model::Machine ring_machine() {
  model::Machine machine = scene::one_side_machine();
  machine.rotor = model::JeffcottRotor{.mass_kg = 0.8, .natural_frequency_hz = 30, .damping_ratio = 0.05};
  machine.kick.reset();
  model::Stop& stop = machine.stops.front();
  stop.geometry = model::AnnularGeometry{};
  stop.stiffness_n_per_m = 4 * 0.8 * std::pow(2 * std::numbers::pi * 30, 2);
  stop.damping = model::ExplicitDamping{0};
  stop.friction = model::NoFriction{};
  stop.casing.reset();
  return machine;
}

}  // namespace rubsweep::ramp
