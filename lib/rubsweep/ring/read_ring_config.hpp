#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/core/vocabulary.hpp"
#include "rubsweep/maps/batch/table_file.hpp"
#include "rubsweep/maps/config/keys/form.hpp"
#include "rubsweep/maps/config/study/axis.hpp"
#include "rubsweep/maps/config/yaml/printer.hpp"
#include "rubsweep/maps/config/yaml/value.hpp"
#include "rubsweep/ring/study.hpp"
#include "rubsweep/ring/system.hpp"

namespace rubsweep::config::ring {

inline constexpr auto parameters = words_of<rubsweep::ring::Parameter>();
/// Allowed speeds, up to more than any rotor reaches. At much higher speeds eigenvalues are only rounding.
inline constexpr model::Range speeds_rpm{.low = 0, .high = 1e7};

/// Reads `chart`: {parameter, load, over}. `load` counts from 0; without it all loads are varied. `over` is
/// an axis (see axis.hpp).
rubsweep::ring::ChartAxis read_ring_chart(const yaml::Value& value,
                                          const std::vector<rubsweep::ring::Load>& loads);
void print_ring_chart(yaml::Printer& printer, const rubsweep::ring::ChartAxis& axis, study::AxisPrint how);

/// One complete configuration of `ringstab`: the study and the directory of its files.
struct RingConfig {
  rubsweep::ring::Study study;
  std::filesystem::path output_directory;
  batch::Captions captions{};
  std::vector<std::string> questions{};  ///< questions about likely slips of units (see unit_slips.hpp)
};

/// Reads a configuration of `ringstab`: ring, loads, friction_coefficient, preload_n (default 0), speed_rpm,
/// chart (optional), output. Problems, overrides and errors are as in run_config.hpp. Speeds are sorted.
RingConfig read_ring_config(const std::filesystem::path& file, const std::vector<std::string>& overrides);

keys::Form ring_form();  ///< All keys of a configuration of `ringstab`.

/// Reads a configuration of `ringstab` from a text; `name` stands for the file in messages. Throws
/// ConfigError.
RingConfig read_ring_config_text(std::string_view text, const std::string& name,
                                 const std::vector<std::string>& overrides);

/// Complete configuration as YAML, defaults included, that reads back as an equal one. Throws ConfigError
/// where the output directory is not UTF-8.
std::string print_ring_config(const RingConfig& config);

/// Digest of everything that decides the numbers, made like study_digest.
std::string ring_study_digest(const rubsweep::ring::Study& study);

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
