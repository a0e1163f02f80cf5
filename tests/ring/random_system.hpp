#pragma once

#include <random>

#include "ring/support.hpp"

namespace rubsweep::ring {

/// Draws random systems: 1 to `most_loads` spring-masses and beams with any motion, position and inclination.
class RandomSystems {
 public:
  explicit RandomSystems(unsigned seed, int most_loads) : engine_(seed), most_loads_(most_loads) {}

  System next() {
    Ring ring = paper_ring();
    ring.nodal_diameters = std::uniform_int_distribution<int>(2, 12)(engine_);
    ring.modal_mass_kg = between(100, 2000);
    ring.modal_stiffness_n_per_m =
        stiffness_of_frequency(between(20, 300), ring.modal_mass_kg, ring.nodal_diameters);
    ring.thickness_ratio = between(0, 0.1);
    System system{.ring = ring, .loads = {}, .friction_coefficient = between(0.01, 0.5)};
    const int loads = std::uniform_int_distribution<int>(1, most_loads_)(engine_);
    for (int j = 0; j < loads; ++j) system.loads.push_back(load());
    return system;
  }

  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(engine_);
  }

 private:
  Load load() {
    const double mass = between(10, 300);
    Load load = between(0, 1) < 0.5
                    ? spring_mass(mass, between(0, 2e6), between(1e4, 2e6))
                    : beam(mass, mass * between(0.46, 1.2), between(1e5, 2e7), between(1e4, 2e6));
    load.angle_deg = between(0, 360);
    const double choice = between(0, 1);
    if (choice < 0.15) load.motion = Motion::radial;
    if (choice > 0.3) load.inclination_deg = between(-90, 90);
    return load;
  }

  std::mt19937_64 engine_;
  int most_loads_;
};

}  // namespace rubsweep::ring
