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
inline constexpr auto motions = words_of<rubsweep::ring::Motion>();
inline constexpr yaml::IntegerRange nodal_diameters{2, 100};
inline constexpr model::Range thickness_ratios{.low = 0, .high = 1, .high_open = true};
inline constexpr std::array<std::string_view, 3> stiffness_keys{
    "modal_stiffness_n_per_m", "natural_frequency_hz", "natural_frequency_rad_per_s"};

/// Reads `loads`. A beam given by its geometry is as long as the radius of the ring.
std::vector<rubsweep::ring::Load> read_ring_loads(const yaml::Value& value,
                                                  const std::optional<double>& ring_radius_m);

/// Prints loads. Beams are printed as modal data, however they were given.
void print_ring_loads(yaml::Printer& printer, const std::vector<rubsweep::ring::Load>& loads);

rubsweep::ring::Ring read_ring(const yaml::Value& value);  ///< Reads `ring`, by modal data or geometry.

/// Prints a ring as modal data, however it was given.
void print_ring(yaml::Printer& printer, const rubsweep::ring::Ring& ring);

}  // namespace rubsweep::config::ring
