#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/maps/config/yaml/value.hpp"

namespace rubsweep::config {

/// Refuses numbers that are certainly in a wrong unit: a clearance as large as the radius (millimetres), a
/// kick that lasts a hundred periods of the rotor (milliseconds), a speed a hundred times the rotor's natural
/// frequency (revolutions per minute), a shaft as soft as air (gigapascals). The library itself would
/// simulate all of these. `root` is a whole configuration whose values have been read without a problem, and
/// `machine` is its machine (null for a configuration without a rotor). Keys that `root` does not have are
/// not judged.
void refuse_unit_slips(const yaml::Value& root, const model::Machine* machine);

/// Questions about an accepted configuration: `file:line:column: key: ... (millimetres?)`. In a list of
/// numbers, or among equal questions, only the first one is asked.
std::vector<std::string> unit_questions(const yaml::Value& root, const model::Machine* machine);

/// Quantities for which numbers in a configuration or on a command line are checked.
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

/// Number that is in range, but implausible in the unit of its key.
struct Slip {
  std::string wrong;     ///< rest of a sentence about the number, with a question about the intended unit
  std::string allowed;   ///< plausible end that the number exceeds
  bool certain = false;  ///< true: refused, since no machine has such a value; false: the user is only asked
};

/// Checks a number; empty where it is plausible. It is compared with scales of `machine` and of the stop with
/// index `stop`. Numbers without a known scale (for example, with `machine` null) are not judged.
std::optional<Slip> slip_of(Quantity quantity, double value, const model::Machine* machine,
                            std::size_t stop = 0);

}  // namespace rubsweep::config
