#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "rubsweep/core/vocabulary.hpp"
#include "rubsweep/maps/config/yaml/printer.hpp"
#include "rubsweep/maps/config/yaml/value.hpp"
#include "rubsweep/ring/system.hpp"

namespace rubsweep::config::ring {

inline constexpr std::size_t max_ring_loads = 64;
inline constexpr model::Range inclinations{.low = -90, .high = 90};
inline constexpr std::array<std::string_view, 2> kinds{"spring_mass", "beam"};
inline constexpr Words<rubsweep::ring::Motion, 3> motions{
    {"both", "radial", "tangential"},
    {rubsweep::ring::Motion::both, rubsweep::ring::Motion::radial, rubsweep::ring::Motion::tangential}};
inline constexpr yaml::IntegerRange nodal_diameters{2, 100};
inline constexpr model::Range thickness_ratios{.low = 0, .high = 1, .high_open = true};
inline constexpr std::array<std::string_view, 3> stiffness_keys{
    "modal_stiffness_n_per_m", "natural_frequency_hz", "natural_frequency_rad_per_s"};

/// `loads`: each of kind spring_mass {mass_kg, radial_stiffness_n_per_m, tangential_stiffness_n_per_m} or
/// beam, by modal data {radial_mass_kg, flexural_mass_kg, rotary_mass_kg, both stiffnesses} or geometry
/// {density_kg_per_m3, section_area_m2, second_moment_m4, youngs_modulus_pa}, as long as the radius of the
/// ring. All: angle_deg, inclination_deg (0), motion (both).
std::vector<rubsweep::ring::Load> read_ring_loads(const yaml::Value& value,
                                                  const std::optional<double>& ring_radius_m);

/// Beams as modal data, however they were given.
void print_ring_loads(yaml::Printer& printer, const std::vector<rubsweep::ring::Load>& loads);

/// `ring`: nodal_diameters, and either modal data (modal_mass_kg, thickness_ratio, optional radius_m, and one
/// of modal_stiffness_n_per_m, natural_frequency_hz, natural_frequency_rad_per_s) or geometry: {radius_m,
/// thickness_m, width_m, density_kg_per_m3, youngs_modulus_pa}.
rubsweep::ring::Ring read_ring(const yaml::Value& value);

/// As modal data, however it was given.
void print_ring(yaml::Printer& printer, const rubsweep::ring::Ring& ring);

}  // namespace rubsweep::config::ring
