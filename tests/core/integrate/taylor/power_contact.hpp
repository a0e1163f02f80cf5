// A rotor that presses by a power of the penetration against a flat or annular wall of a moving casing.
#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "core/integrate/curved_machine.hpp"
#include "rubsweep/core/integrate/law/dynamics.hpp"
#include "rubsweep/core/integrate/run/pulse_times.hpp"
#include "rubsweep/core/integrate/run/scaled_system.hpp"
#include "rubsweep/core/integrate/taylor/regular_expansion.hpp"

namespace rubsweep::integrate::taylor {

struct PowerContactCase {
  double exponent = 1.5;
  bool annular = false;
  contact::Mode mode = contact::Mode::sprung;
  model::Friction friction = model::StribeckFriction{{0, 0, 0, 0.2, 0.1, 0}};
  double harder = 1;  ///< factor of the stiffness
};

template <int N>
struct PowerContact {
  explicit PowerContact(const PowerContactCase& a)
      : scene(made(a)), system(run::scale<N>(scene)), law(system, 0) {
    law.follow(pulses);
    law.modes()[0] = a.mode;
    damp(0.8);
  }

  /// Begins the impact with the speed for which the damping is x over this speed.
  void damp(double speed) { law.begin_impact(0, speed); }

  bool expand(RegularExpansion<N>& motion, const std::vector<double>& state) {
    std::vector<double> rate(8);
    law(state, rate, phase_rad);
    return motion.expand(state, rate, phase_rad, law);
  }

  static scene::Scene made(const PowerContactCase& a) {
    scene::Contact contact;
    if (a.annular)
      contact.wall = contact::AnnularWall{};
    else
      contact.wall = contact::FlatWall{{0.28, 0.96}};
    contact.casing_point = 1;
    contact.clearance_m = 1e-3;
    contact.surface_speed_m_per_s = 12;
    contact.friction = a.friction;
    const double stiffness = a.harder * 1e6 / std::pow(5e-5, a.exponent - 1);
    test_curved::give_law(
        test_curved::power_stop(stiffness, a.exponent, model::ImpactDamping::hunt_crossley, 0.7), contact);
    return test_curved::rotor_and_casing({contact}, 40);
  }

  /// A state with this penetration and about this closing speed.
  static std::vector<double> state(double penetration, double speed) {
    const double length = 1 + penetration;
    return {0.28 * length + 0.1, 0.96 * length - 0.05, 0.1,  -0.05,
            0.28 * speed - 0.5,  0.96 * speed + 0.2,   0.02, 0.03};
  }

  scene::Scene scene;
  run::ScaledSystem<N> system;
  run::PulseTimes pulses{scene, system.scale, 2 * std::numbers::pi};
  law::Dynamics<N, false> law;
  static constexpr double phase_rad = 0.5;
};

/// Cases of every exponent, wall and kind of friction, pressing and released.
inline std::vector<PowerContactCase> power_contact_cases() {
  std::vector<PowerContactCase> cases;
  for (const bool annular : {false, true}) {
    for (const double exponent : {1.0, 1.5, 2.0, 2.5, 3.0})
      cases.push_back({.exponent = exponent, .annular = annular});
    cases.push_back({.annular = annular, .friction = model::ConstantFriction{0.2}});
    cases.push_back({.annular = annular, .friction = model::NoFriction{}});
    cases.push_back({.annular = annular, .mode = contact::Mode::released});
  }
  return cases;
}

}  // namespace rubsweep::integrate::taylor
