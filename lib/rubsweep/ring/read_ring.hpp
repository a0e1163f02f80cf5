#pragma once

#include "rubsweep/maps/config/yaml/printer.hpp"
#include "rubsweep/maps/config/yaml/value.hpp"
#include "rubsweep/ring/system.hpp"

namespace rubsweep::config::ring {

/// `ring`: nodal_diameters, and either modal data (modal_mass_kg, thickness_ratio, optional radius_m, and one
/// of modal_stiffness_n_per_m, natural_frequency_hz, natural_frequency_rad_per_s) or geometry: {radius_m,
/// thickness_m, width_m, density_kg_per_m3, youngs_modulus_pa}.
rubsweep::ring::Ring read_ring(const yaml::Value& value);

/// As modal data, however it was given.
void print_ring(yaml::Printer& printer, const rubsweep::ring::Ring& ring);

}  // namespace rubsweep::config::ring
