#include "rubsweep/ring/static_load.hpp"

#include <cmath>

#include "rubsweep/core/numerics/dense/lu.hpp"
#include "rubsweep/ring/assembly.hpp"

namespace rubsweep::ring {

bool StaticLoad::valid() const {
  for (std::size_t j = 0; j < normal_n.size(); ++j) {
    if (!(std::isfinite(normal_n[j]) && normal_n[j] > 0 && slip_m_per_s[j] > 0)) return false;
  }
  return true;
}

StaticLoad static_load(const System& system, double speed_rad_per_s) {
  const double speed2 = speed_rad_per_s * speed_rad_per_s, radius = system.ring.radius_m.value();
  const Matrices matrices = assemble(system);
  const Eigen::VectorXd rest =
      numerics::dense::solve_full_pivot(matrices.stiffness - speed2 * matrices.softening,
                                        Eigen::VectorXd(matrices.force + speed2 * matrices.centrifugal));
  const auto coordinates = load_coordinates(system);
  StaticLoad result;
  for (std::size_t j = 0; j < system.loads.size(); ++j) {
    const Load& load = system.loads[j];
    const LoadMaps maps = load_maps(system.ring, load, coordinates[j], matrices.coordinates());
    const Eigen::Vector2d stiffness(
        load.radial_stiffness_n_per_m - speed2 * load.radial_mass_kg,
        load.tangential_stiffness_n_per_m - speed2 * (load.flexural_mass_kg - load.rotary_mass_kg));
    const Eigen::Vector2d tip = maps.tip * rest;
    const Eigen::Vector2d carried(stiffness(0) * tip(0) - speed2 * load.centrifugal_mass_kg * radius,
                                  stiffness(1) * tip(1));
    result.normal_n.push_back(maps.inward * carried + system.preload_n);
    // The tip runs at Omega (R - u); the surface at Omega eta u, by the standing wave that the ring turns
    // through.
    const double inward = maps.inward * tip;
    result.slip_m_per_s.push_back(speed_rad_per_s * (radius + (surface_ratio(system.ring) - 1) * inward));
  }
  return result;
}

}  // namespace rubsweep::ring
