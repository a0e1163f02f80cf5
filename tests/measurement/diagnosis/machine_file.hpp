#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "maps/batch/temporary_directory.hpp"

namespace rubsweep::diagnosis {

inline constexpr std::string_view jeffcott =
    "{kind: jeffcott, mass_kg: 0.8, natural_frequency_hz: 30, damping_ratio: 0.02}";

inline constexpr std::string_view kit = R"({kind: rotor_kit, damping_ratio: 0.02,
  shaft: [{length_m: 0.4, outer_diameter_m: 0.01, youngs_modulus_pa: 2.1e11, shear_modulus_pa: 8.0e10, density_kg_per_m3: 7800}],
  supports: [{position_m: 0, stiffness_x_n_per_m: 1.0e6, stiffness_y_n_per_m: 1.0e6}, {position_m: 0.4, stiffness_x_n_per_m: 1.0e6, stiffness_y_n_per_m: 1.0e6}],
  discs: [{position_m: 0.2, mass_kg: 0.8, polar_inertia_kg_m2: 0, diametral_inertia_kg_m2: 0}],
  sensors: [{position_m: 0.1}]})";

/// A configuration with one stop and this rotor, in its own directory.
struct MachineFile {
  TemporaryDirectory temporary;
  std::filesystem::path path = temporary.path() / "machine.yaml";

  explicit MachineFile(std::string_view rotor = jeffcott, std::string_view more = "") {
    std::ofstream file(path);
    file << "rotor: " << rotor << R"(
stops:
  - {kind: one_side, angle_deg: 90, clearance_m: 0.001, stiffness_n_per_m: 2.0e6, contact_radius_m: 0.0375,
     restitution: 0.7)"
         << (rotor.starts_with("{kind: rotor_kit") ? ", position_m: 0.3" : "") << "}\n"
         << more << R"(
sweep: {speed_hz: {values: [60]}, whirl_ratio: {values: [0.25]}}
output: {directory: results}
)";
  }

  /// Writes parameters.csv and correlation.csv with one fitted parameter beside the configuration.
  void write_fit(std::string_view name, double value, double low, double high) const {
    std::ofstream(temporary.path() / "parameters.csv")
        << "parameter,value,standard_error,low_95,high_95,start,at_bound\n"
        << name << ',' << value << ',' << (high - low) / 4 << ',' << low << ',' << high << ',' << value
        << ",0\n";
    std::ofstream(temporary.path() / "correlation.csv") << "parameter," << name << '\n' << name << ",1\n";
  }
};

}  // namespace rubsweep::diagnosis
