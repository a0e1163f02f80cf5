#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/maps/batch/table_file.hpp"
#include "rubsweep/maps/config/keys/form.hpp"
#include "rubsweep/maps/config/study/axis.hpp"
#include "rubsweep/maps/config/yaml/printer.hpp"
#include "rubsweep/maps/config/yaml/value.hpp"
#include "rubsweep/ring/study.hpp"

namespace rubsweep::config::ring {

inline constexpr auto parameters = words_of<rubsweep::ring::Parameter>();
/// Allowed speeds, up to more than any rotor reaches. At much higher speeds, eigenvalues would be only
/// rounding.
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

/// All keys of a configuration of `ringstab`.
keys::Form ring_form();

/// Reads a configuration of `ringstab` from a text; `name` stands for the file in messages. Throws
/// ConfigError.
RingConfig read_ring_config_text(std::string_view text, const std::string& name,
                                 const std::vector<std::string>& overrides);

/// Complete configuration as YAML, defaults included, that reads back as an equal one. Throws ConfigError
/// where the output directory is not UTF-8.
std::string print_ring_config(const RingConfig& config);

/// Digest of everything that decides the numbers, made like study_digest.
std::string ring_study_digest(const rubsweep::ring::Study& study);

}  // namespace rubsweep::config::ring
