#pragma once

#include <cstddef>
#include <string>

#include "rubsweep/core/model/rotor_kit.hpp"

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

}  // namespace rubsweep::model
