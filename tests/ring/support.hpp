#pragma once

#include <numbers>
#include <vector>

#include "rubsweep/ring/system.hpp"

namespace rubsweep::ring {

/// Angular speed of one rpm, rad/s.
inline constexpr double rpm = std::numbers::pi / 30;

/// The ring with which the paper's Table 1 and the caption of Fig. 5 are reproduced.
inline Ring paper_ring() {
  return {.nodal_diameters = 2,
          .modal_mass_kg = 742,
          .modal_stiffness_n_per_m = stiffness_of_frequency(34.4, 742, 2),
          .thickness_ratio = 0.0138,
          .radius_m = 1};
}

inline Load at(double angle_deg, Load load) {
  load.angle_deg = angle_deg;
  return load;
}

/// The paper's spring-masses (100 kg, k_r = k_t = 1e6 N/m) at these angles.
inline System spring_masses(const std::vector<double>& angles_deg, double friction = 0.1) {
  System system{.ring = paper_ring(), .loads = {}, .friction_coefficient = friction};
  for (const double angle : angles_deg) system.loads.push_back(at(angle, spring_mass(100, 1e6, 1e6)));
  return system;
}

}  // namespace rubsweep::ring
