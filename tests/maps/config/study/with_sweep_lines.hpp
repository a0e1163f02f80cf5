#pragma once

#include <string>

namespace rubsweep::config::study {

/// The minimal configuration with the axes of its sweep on separate lines.
inline std::string with_sweep_lines(const std::string& axes) {
  return "rotor: {kind: jeffcott, mass_kg: 0.8, natural_frequency_hz: 30, damping_ratio: 0.02}\n"
         "stops:\n"
         "  - {kind: one_side, angle_deg: 90, clearance_m: 1e-3, stiffness_n_per_m: 2e6, restitution: 0.7,\n"
         "     contact_radius_m: 0.0375}\n"
         "sweep:\n  " +
         axes + "\noutput: {directory: results}\n";
}

inline const std::string ratio = "whirl_ratio: {values: [0.4]}";

}  // namespace rubsweep::config::study
