#pragma once

#include <array>

#include "core/integrate/largest_difference.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::integrate::taylor {

/// A scene of parameter set C with an annular stop: circular and oval motions in permanent contact.
inline scene::Scene set_c_scene(double speed_hz, double whirl_ratio,
                                std::array<double, 2> offset_m = {0, 0}) {
  test::OneSideRotor rotor;
  rotor.damping_ratio = 0.04;
  rotor.restitution = 0.5;
  rotor.casing_damping_ratio = 1;
  rotor.friction_coefficient = 0.02;
  rotor.kick_n = 150;
  model::Machine machine = test::machine_of(rotor);
  machine.stops[0].geometry = model::AnnularGeometry{offset_m};
  return scene::build_cell(machine, speed_hz, scene::WhirlRatio{whirl_ratio}).scene;
}

}  // namespace rubsweep::integrate::taylor
