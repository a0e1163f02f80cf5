#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string>

#include "rubsweep/core/model/machine.hpp"

namespace rubsweep::model {

/// Key of a support for messages: that of the configuration, or of the file of another program.
inline std::string support_path(const RotorKit& kit, std::size_t support) {
  return kit.from_file ? "rotor.file." + kit.supports[support].name
                       : "rotor.supports." + std::to_string(support);
}

/// Name of a support for people, without the class that ROSS writes before the tag of an element.
inline std::string support_name(const RotorKit& kit, std::size_t support) {
  const std::string& name = kit.supports[support].name;
  return kit.from_file ? name.substr(name.find('_') + 1) : name;
}

/// The name of an element as it stands behind its number: " (name)", or nothing where it has none.
inline std::string in_brackets(const std::string& name) { return name.empty() ? "" : " (" + name + ")"; }

/// Name of an element in a list of names that may be shorter than that of the elements, or empty.
inline std::string name_at(const std::vector<std::string>& names, std::size_t element) {
  return element < names.size() ? names[element] : "";
}

/// Name of a sensor of a kit; empty where it has none, and for the sensors that watch any other machine.
inline std::string sensor_name(const Machine& machine, std::size_t sensor) {
  const RotorKit* kit = kit_of(machine);
  return kit != nullptr && sensor < kit->sensors.size() ? kit->sensors[sensor].name : "";
}

/// Number of a sensor with its name, if it has one, and its direction: "0 (drive end, 45 deg)".
inline std::string sensor_label(std::size_t sensor, const std::string& name, double angle_deg) {
  return fmt::format("{} ({}{}{:g} deg)", sensor, name, name.empty() ? "" : ", ", angle_deg);
}

}  // namespace rubsweep::model
