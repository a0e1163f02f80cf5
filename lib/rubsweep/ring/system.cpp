#include "rubsweep/ring/system.hpp"

#include <cmath>
#include <numbers>

namespace rubsweep::ring {
namespace {

using std::numbers::pi;

double nodal(int nodal_diameters) { return static_cast<double>(nodal_diameters); }

}  // namespace

Load spring_mass(double mass_kg, double radial_stiffness_n_per_m, double tangential_stiffness_n_per_m) {
  Load load;
  load.radial_mass_kg = load.flexural_mass_kg = load.gyroscopic_mass_kg = load.centrifugal_mass_kg = mass_kg;
  load.radial_stiffness_n_per_m = radial_stiffness_n_per_m;
  load.tangential_stiffness_n_per_m = tangential_stiffness_n_per_m;
  return load;
}

Load beam(double radial_mass_kg, double flexural_mass_kg, double radial_stiffness_n_per_m,
          double tangential_stiffness_n_per_m) {
  Load load;
  load.kind = LoadKind::beam;
  load.radial_mass_kg = radial_mass_kg;
  load.flexural_mass_kg = flexural_mass_kg;
  load.rotary_mass_kg = flexural_mass_kg - 2 * radial_mass_kg * (1.5 - 4 / pi);
  load.gyroscopic_mass_kg = 2 * radial_mass_kg / pi;
  load.centrifugal_mass_kg = 8 * radial_mass_kg / square(pi);
  load.radial_stiffness_n_per_m = radial_stiffness_n_per_m;
  load.tangential_stiffness_n_per_m = tangential_stiffness_n_per_m;
  return load;
}

Load beam(const BeamGeometry& geometry, double length_m) {
  const double area = geometry.section_area_m2, moment = geometry.second_moment_m4;
  const double mass = geometry.density_kg_per_m3 * area * length_m;
  const double rotary = geometry.density_kg_per_m3 * moment * square(pi) / (8 * length_m);
  return beam(mass / 2, mass * (1.5 - 4 / pi) + rotary,
              geometry.youngs_modulus_pa * area * square(pi) / (8 * length_m),
              geometry.youngs_modulus_pa * moment * square(square(pi)) / (32 * length_m * square(length_m)));
}

Ring ring(const RingGeometry& geometry, int nodal_diameters) {
  const double radius = geometry.radius_m, thickness = geometry.thickness_m;
  const double moment = geometry.width_m * thickness * square(thickness) / 12;
  return {.nodal_diameters = nodal_diameters,
          .modal_mass_kg = geometry.density_kg_per_m3 * geometry.width_m * thickness * radius * pi,
          .modal_stiffness_n_per_m = geometry.youngs_modulus_pa * moment * pi / (radius * square(radius)),
          .thickness_ratio = thickness / radius,
          .radius_m = radius};
}

double amplitude_mass_kg(const Ring& ring) {
  return ring.modal_mass_kg * (square(nodal(ring.nodal_diameters)) + 1);
}

double critical_speed(const Ring& ring) {
  const double n2 = square(nodal(ring.nodal_diameters));
  return (n2 - 1) * std::sqrt(ring.modal_stiffness_n_per_m / amplitude_mass_kg(ring));
}

double stiffness_of_frequency(double frequency_rad_per_s, double modal_mass_kg, int nodal_diameters) {
  const double n2 = square(nodal(nodal_diameters));
  return modal_mass_kg * (n2 + 1) * square(frequency_rad_per_s) / (n2 * square(n2 - 1));
}

double surface_ratio(const Ring& ring) {
  return 1 + ring.thickness_ratio * (square(nodal(ring.nodal_diameters)) - 1) / 2;
}

}  // namespace rubsweep::ring
