#pragma once

#include <cmath>
#include <complex>
#include <numbers>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include "rubsweep/core/integrate/run/scaled_system.hpp"
#include "rubsweep/core/scene/build_scene.hpp"
#include "support/long_double_reference.hpp"
#include "support/rolling_scene.hpp"
#include "support/set_a_cell.hpp"
#include "support/simple_scenes.hpp"

namespace rubsweep::test {

/// A scene that is hard for a solver, and the expected result. `hard_scenes` lists all; any solver can run
/// them.
struct HardScene {
  std::string name;
  scene::Scene scene;
  int turns = 1;
  /// Scaled section after `turns`, from a closed form or from a reference without code of the solvers. Empty:
  /// two steppers of the library must agree.
  std::vector<double> section = {};
  std::optional<int> hits = {};         ///< impacts in all turns
  std::optional<double> energy_j = {};  ///< energy at the end = energy at the start, J
  double error_per_tolerance = 100;     ///< largest section error / relative tolerance of the solver
};

/// Scaled section of a one-mass scene with the state z, v (metres, m/s).
inline std::vector<double> section_of(const scene::Scene& scene, std::complex<double> z,
                                      std::complex<double> v) {
  const double length = scene.length_scale_m, speed = length * scene.speed_rad_per_s;
  return {z.real() / length, z.imag() / length, v.real() / speed, v.imag() / speed};
}

/// Kinetic energy plus potential energy of structure and contact springs for a scaled section.
inline double stored_energy_j(const scene::Scene& scene, const std::vector<double>& section) {
  const Eigen::Index n = scene.structure.coordinates();
  const Eigen::Map<const Eigen::VectorXd> state(section.data(), 2 * n);
  const Eigen::VectorXd q = scene.length_scale_m * state.head(n);
  const Eigen::VectorXd v = scene.length_scale_m * scene.speed_rad_per_s * state.tail(n);
  double energy = (v.dot(scene.structure.mass * v) + q.dot(scene.structure.stiffness * q)) / 2;
  for (const scene::Contact& c : scene.contacts) {
    const Eigen::Vector2d d = scene::relative_map(scene.structure, c) * q + contact::offset(c.wall);
    const double penetration = d.dot(contact::normal_at(c.wall, d)) - c.clearance_m;
    if (penetration > 0) energy += c.stiffness_n_per_m * penetration * penetration / 2;
  }
  return energy;
}

/// A cell of the one-side machine, compared with hand-written equations in long double.
inline HardScene by_hand(std::string name, const OneSideRotor& rotor, int turns, int steps_per_turn,
                         double error_per_tolerance) {
  HardScene hard{.name = std::move(name), .scene = cell_of(rotor).scene, .turns = turns};
  const auto state = long_double_sections(rotor, turns, steps_per_turn).back();
  const double speed = rotor.clearance_m * 2 * std::numbers::pi * rotor.speed_hz;
  for (std::size_t i = 0; i < state.size(); ++i)
    hard.section.push_back(static_cast<double>(state[i]) / (i < 4 ? rotor.clearance_m : speed));
  hard.error_per_tolerance = error_per_tolerance;
  return hard;
}

/// A free vibration x = -cos 20 t, whose peak is exactly at a damped wall.
inline HardScene graze_of_a_free_oscillation() {
  auto scene = one_mass_scene(1, 400, 0, 0.25, 1);
  scene.displacement_m << -1, 0;
  scene.contacts.push_back(wall_across_x(1, 1, 1e4, 1));
  const double phase = 20 * 0.25 * 8;
  HardScene hard{.name = "graze_of_a_free_oscillation", .scene = scene, .turns = 8};
  hard.section = section_of(scene, -std::cos(phase), 20 * std::sin(phase));
  return hard;
}

/// Forced whirl z = i e^{i w t} of a mass of 1 kg on 20 N/m; a wall stands at the distance of its amplitude.
inline scene::Scene whirl_up_to_a_wall(double speed) {
  const double stiffness = 20, damping = 0.4;
  const std::complex<double> i(0, 1);
  auto scene = one_mass_scene(1, stiffness, damping, 2 * std::numbers::pi / speed, 1);
  const std::complex<double> force = i * (stiffness - speed * speed + i * damping * speed);
  scene.harmonic_n << force, -i * force;
  scene.displacement_m << 0, 1;
  scene.velocity_m_per_s << -speed, 0;
  scene::Contact wall = wall_across_x(1, 1, 1e4, 1);
  wall.friction = model::StribeckFriction{{0, 0, 0, 0.1, 100, 0}};
  scene.contacts.push_back(wall);
  return scene;
}

/// The circle touches a flat wall once per turn.
inline HardScene graze_in_every_turn() {
  HardScene hard{.name = "graze_in_every_turn", .scene = whirl_up_to_a_wall(10), .turns = 20};
  hard.section = section_of(hard.scene, {0, 1}, -10);
  return hard;
}

/// The circle coincides with an annular stop: permanent contact without penetration. Below the natural
/// frequency, where the stop does not shift the rotor's phase, and without friction, this circle is
/// attracting.
inline HardScene graze_all_along_a_ring() {
  HardScene hard{.name = "graze_all_along_a_ring", .scene = whirl_up_to_a_wall(3)};
  hard.scene.contacts[0].wall = contact::AnnularWall{};
  hard.scene.contacts[0].friction = model::NoFriction{};
  hard.section = section_of(hard.scene, {0, 1}, -3);
  return hard;
}

/// A rotor that hits two undamped walls at +-45 degrees at the same instant. By symmetry they act like one
/// wall in x at sqrt(2) times the clearance, with the same stiffness. Then x = sin(w t) / w in flight, and in
/// contact half an oscillation about x_e = K X / (k + K), after which the rotor returns with the same speed.
inline HardScene two_stops_at_once() {
  const double stiffness = 1e5, w = 10, wall_at = std::numbers::sqrt2 * 1e-3;
  auto scene = one_mass_scene(1, w * w, 0, 0.5, 1e-3);
  scene.velocity_m_per_s << 1, 0;
  for (const int sign : {1, -1}) {
    scene::Contact wall = wall_across_x(1, 1e-3, stiffness, 0);
    wall.wall = contact::FlatWall{{std::sqrt(0.5), sign * std::sqrt(0.5)}};
    scene.contacts.push_back(wall);
  }
  HardScene hard{.name = "two_stops_at_once", .scene = scene, .turns = 3};
  const double flight = std::asin(w * wall_at) / w, in_contact = std::sqrt(w * w + stiffness);
  const double above = wall_at - stiffness * wall_at / (in_contact * in_contact);
  const double contact = 2 * std::atan2(std::cos(w * flight) / in_contact, above) / in_contact;
  const double cycle = 2 * flight + contact + std::numbers::pi / w;
  const double into_cycle = std::fmod(0.5 * hard.turns, cycle);
  const double since_centre = into_cycle - 2 * flight - contact;  // on the -x side there is no wall
  hard.section = section_of(scene, -std::sin(w * since_centre) / w, -std::cos(w * since_centre));
  hard.hits = 2 * (static_cast<int>(0.5 * hard.turns / cycle) + 1);
  hard.error_per_tolerance = 3e3;
  return hard;
}

/// Two moving casings without damping, friction and excitation: the energy is conserved.
inline HardScene nothing_damped() {
  model::Machine machine = machine_of({});
  std::get<model::JeffcottRotor>(machine.rotor).damping_ratio = 0;
  machine.kick.reset();
  auto& stop = machine.stops[0];
  stop.damping = model::ExplicitDamping{0};
  stop.friction = model::NoFriction{};
  stop.casing->damping_ratio = 0;
  machine.stops.push_back(stop);
  machine.stops[1].geometry = model::OneSideGeometry{-90};
  HardScene hard{.name = "nothing_damped",
                 .scene = scene::build_cell(machine, 75, scene::WhirlRatio{0}).scene};
  hard.scene.velocity_m_per_s[0] = 0.1;
  hard.scene.velocity_m_per_s[1] = 0.7;
  hard.turns = 8;
  hard.energy_j = 0.8 * (0.1 * 0.1 + 0.7 * 0.7) / 2;
  hard.error_per_tolerance = 2e4;
  return hard;
}

/// A shaft of zero radius: the slip comes from rotor and casing, has either sign, and the tanh switches
/// within 0.1 mm/s.
inline HardScene slip_reversal() {
  OneSideRotor rotor;
  rotor.contact_radius_m = 0;
  rotor.friction_steepness_s_per_m = 1e4;
  return {.name = "slip_reversal", .scene = cell_of(rotor).scene, .turns = 4};
}

/// A tanh with steepness 1e4 s/m, which never saturates here.
inline HardScene backward_rolling() {
  const RollingScene rolling = rolling_scene(1e4);
  HardScene hard{.name = "backward_rolling", .scene = rolling.scene, .turns = 3};
  hard.section = section_of(hard.scene, rolling.displacement(hard.turns), rolling.velocity(hard.turns));
  return hard;
}

/// A kicked shaft without unbalance.
inline HardScene without_unbalance() {
  return by_hand("without_unbalance", {.whirl_ratio = 0}, 4, 2000, 100);
}

inline HardScene speed_at_the_natural_frequency() {
  return by_hand("speed_at_the_natural_frequency", {.speed_hz = OneSideRotor().natural_frequency_hz}, 4, 4000,
                 500);
}

/// The rotor reaches and leaves the wall during a kick of nine tenths of a turn.
inline HardScene stop_reached_during_the_kick() {
  return by_hand("stop_reached_during_the_kick", {.kick_s = 0.012}, 4, 2000, 100);
}

inline HardScene kick_longer_than_a_turn() {
  return by_hand("kick_longer_than_a_turn", {.kick_s = 0.03}, 5, 2000, 500);
}

inline HardScene clearance_of_a_micrometre() {
  return by_hand("clearance_of_a_micrometre", {.clearance_m = 1e-6}, 2, 3000, 3e3);
}

inline HardScene stiffness_of_1e10() {
  return by_hand("stiffness_of_1e10", {.stiffness_n_per_m = 1e10}, 2, 20000, 100);
}

inline HardScene restitution_of_a_twentieth() {
  return by_hand("restitution_of_a_twentieth", {.restitution = 0.05}, 4, 2000, 100);
}

inline HardScene casing_of_a_gram() {
  return by_hand("casing_of_a_gram", {.casing_mass_kg = 1e-3}, 4, 4000, 100);
}

/// Functions that make the hard scenes, so that one test makes one scene.
struct NamedHardScene {
  const char* name;
  HardScene (*make)();
  // NOLINTNEXTLINE(readability-identifier-naming): GoogleTest looks for this name
  friend void PrintTo(const NamedHardScene& scene, std::ostream* out) { *out << scene.name; }
};
inline constexpr NamedHardScene hard_scenes[] = {
    {"graze_of_a_free_oscillation", graze_of_a_free_oscillation},
    {"graze_in_every_turn", graze_in_every_turn},
    {"graze_all_along_a_ring", graze_all_along_a_ring},
    {"two_stops_at_once", two_stops_at_once},
    {"stop_reached_during_the_kick", stop_reached_during_the_kick},
    {"kick_longer_than_a_turn", kick_longer_than_a_turn},
    {"clearance_of_a_micrometre", clearance_of_a_micrometre},
    {"stiffness_of_1e10", stiffness_of_1e10},
    {"restitution_of_a_twentieth", restitution_of_a_twentieth},
    {"casing_of_a_gram", casing_of_a_gram},
    {"nothing_damped", nothing_damped},
    {"slip_reversal", slip_reversal},
    {"backward_rolling", backward_rolling},
    {"speed_at_the_natural_frequency", speed_at_the_natural_frequency},
    {"without_unbalance", without_unbalance},
};

}  // namespace rubsweep::test
