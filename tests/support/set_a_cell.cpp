#include "support/set_a_cell.hpp"

namespace rubsweep::test {

model::Machine machine_of(const OneSideRotor& rotor) {
  model::Stop stop;
  stop.geometry = model::OneSideGeometry{90};
  stop.clearance_m = rotor.clearance_m;
  stop.stiffness_n_per_m = rotor.stiffness_n_per_m;
  stop.damping = model::NominalRestitution{rotor.restitution};
  stop.contact_radius_m = rotor.contact_radius_m;
  stop.friction =
      model::StribeckFriction{{0, 0, 0, rotor.friction_coefficient, rotor.friction_steepness_s_per_m, 0}};
  stop.casing =
      model::Casing{rotor.casing_mass_kg, rotor.casing_stiffness_n_per_m, rotor.casing_damping_ratio};
  model::Machine machine;
  machine.rotor = model::JeffcottRotor{rotor.mass_kg, rotor.natural_frequency_hz, rotor.damping_ratio};
  machine.stops.push_back(stop);
  machine.kick = model::Kick{rotor.kick_n, rotor.kick_s, {}};
  return machine;
}

scene::Cell cell_of(const OneSideRotor& rotor) {
  return scene::build_cell(machine_of(rotor), rotor.speed_hz, scene::WhirlRatio{rotor.whirl_ratio});
}

double section_error(const std::vector<double>& section, const OneSideState<long double>& reference,
                     const OneSideRotor& rotor) {
  const long double omega = 2 * std::numbers::pi_v<long double> * rotor.speed_hz;
  long double largest = 0;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    const long double unit = rotor.clearance_m * (i < reference.size() / 2 ? 1 : omega);
    largest = std::max(largest, std::abs(section[i] - reference[i] / unit));
  }
  return static_cast<double>(largest);
}

}  // namespace rubsweep::test
