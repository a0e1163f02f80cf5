#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "rubsweep/core/model/machine.hpp"

namespace rubsweep::config {

/// Quantities that a number of a configuration or a command line may stand for.
enum class Quantity {
  speed_hz,
  speed_rpm,
  whirl_ratio,
  eccentricity_m,
  unbalance_g_mm,
  clearance_m,
  contact_radius_m,
  contact_stiffness_n_per_m,
  power_stiffness_n_per_m_n,
  support_stiffness_n_per_m,
  angle_deg,
  damping_ratio,
  kick_duration_s,
  kick_force_n,
  friction_coefficient,
  gravity_m_per_s2,
  displacement_m,
  diameter_m,
  length_m,
  modulus_pa,
  density_kg_per_m3
};

/// A number that is in range but cannot, or can hardly, be meant in the unit of its key.
struct Slip {
  std::string wrong;     ///< finishes a sentence about the number, with the question what was meant
  std::string allowed;   ///< the plausible end that it is beyond
  bool certain = false;  ///< no machine has such a number: refused; else asked about
};

/// Empty where the number is plausible. `machine` (null: not known) gives the scales of comparison, at stop
/// `stop` where there are several; numbers without a known scale are not judged.
std::optional<Slip> slip_of(Quantity quantity, double value, const model::Machine* machine,
                            std::size_t stop = 0);

}  // namespace rubsweep::config
