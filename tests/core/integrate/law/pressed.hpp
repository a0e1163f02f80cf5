#pragma once

#include <numbers>
#include <vector>

#include "rubsweep/core/integrate/law/settle_slips.hpp"
#include "support/simple_scenes.hpp"

namespace rubsweep::test {

/// Unit mass on a unit spring that penetrates a wall across x by the share `pressed` of its clearance. The
/// friction coefficient is 0.5, the surface moves at 0.3.
struct Pressed {
  explicit Pressed(double y, double y_rate, double pressed = 0.02)
      : scene(with_wall()),
        system(integrate::run::scale<2>(scene)),
        law(system, 0),
        state{1 + pressed, y, 0, y_rate} {
    law.modes()[0] = contact::Mode::sprung;
  }

  static scene::Scene with_wall() {
    auto scene = one_mass_scene(1, 1, 0, 2 * std::numbers::pi, 1);
    scene::Contact wall = wall_across_x(1, 1, 100, 0);
    wall.friction = model::ConstantFriction{0.5};
    wall.surface_speed_m_per_s = 0.3;
    scene.contacts.push_back(wall);
    return scene;
  }

  contact::Slip entered() {
    integrate::law::enter_slips_by_state(law, state, rate, 0);
    return law.slips()[0];
  }

  scene::Scene scene;
  integrate::run::ScaledSystem<2> system;
  integrate::law::Dynamics<2, false> law;
  std::vector<double> state, rate = std::vector<double>(4);
};

}  // namespace rubsweep::test
