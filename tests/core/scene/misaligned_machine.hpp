#pragma once

#include <cmath>
#include <numbers>

#include "core/scene/kit_machine.hpp"

namespace rubsweep::scene {

/// A rigid shaft that drives a light one, with a disc in its middle, through a coupling that does not resist
/// tilting. The light shaft has a soft bearing directly behind the coupling and another one at its end, so
/// that misalignment strains the coupling. In bending it is a Jeffcott rotor.
struct MisalignedRotor {
  double coupling_n_per_m = 2e5, behind_n_per_m = 5e4, end_n_per_m = 3e4;
  double length_m = 0.4, mass_kg = 0.8, damping_ratio = 0.02;
  double misalignment_m = 5e-4, misalignment_deg = 30, asymmetry_ratio = 0.1, stiff_axis_deg = 20;

  model::Machine machine() const {
    model::Machine machine = one_side_machine();
    const model::ShaftLayer steel{.outer_diameter_m = 0.01,
                                  .youngs_modulus_pa = 2.1e11,
                                  .shear_modulus_pa = 8.1e10,
                                  .density_kg_per_m3 = 1e-7};
    model::ShaftLayer rigid = steel;
    rigid.outer_diameter_m = 0.1;
    model::RotorKit kit;
    kit.shaft = {{rigid, 0.1}, {steel, length_m}};
    kit.discs = {{.position_m = 0.1 + length_m / 2,
                  .mass_kg = mass_kg,
                  .polar_inertia_kg_m2 = 1e-9,
                  .diametral_inertia_kg_m2 = 1e-9}};
    const auto support = [&kit](double position_m, double stiffness_n_per_m) {
      model::Support added;
      added.position_m = position_m;
      added.stiffness_x_n_per_m = added.stiffness_y_n_per_m = stiffness_n_per_m;
      kit.supports.push_back(added);
    };
    support(0, 1e10);
    support(0.095, 1e10);
    support(0.1 + 1e-5 * length_m, behind_n_per_m);
    support(0.1 + length_m, end_n_per_m);
    kit.couplings = {{.position_m = 0.1,
                      .lateral_stiffness_n_per_m = coupling_n_per_m,
                      .angular_stiffness_nm_per_rad = 1e-3,
                      .parallel_misalignment_m = misalignment_m,
                      .parallel_misalignment_angle_deg = misalignment_deg,
                      .lateral_asymmetry_ratio = asymmetry_ratio,
                      .stiff_axis_phase_deg = stiff_axis_deg}};
    kit.damping_ratio = {damping_ratio};
    kit.modes = 2;
    kit.elements = 8;
    machine.rotor = kit;
    machine.stops.front().position_m = 0.1 + length_m / 2;
    return machine;
  }

  /// Compliance of the middle relative to the line through both ends, m/N: bending and Cowper's shear.
  double bent_m_per_n() const {
    constexpr double pi = std::numbers::pi, diameter = 0.01, young = 2.1e11, shear = 8.1e10;
    const double area = pi / 4 * diameter * diameter, moment = area * diameter * diameter / 16,
                 nu = young / (2 * shear) - 1, coefficient = 6 * (1 + nu) / (7 + 6 * nu);
    return length_m * length_m * length_m / (48 * young * moment) +
           length_m / (4 * coefficient * shear * area);
  }
  /// Stiffness at the disc, equal in all directions.
  double stiffness_n_per_m() const {
    return 1 / (1 / (4 * (coupling_n_per_m + behind_n_per_m)) + 1 / (4 * end_n_per_m) + bent_m_per_n());
  }
  double natural_rad_per_s() const { return std::sqrt(stiffness_n_per_m() / mass_kg); }
};

}  // namespace rubsweep::scene
