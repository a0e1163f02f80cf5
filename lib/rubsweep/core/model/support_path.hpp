#pragma once

#include <cstddef>
#include <string>

#include "rubsweep/core/model/rotor_kit.hpp"

namespace rubsweep::model {

/// Key of a support for messages; a support from a file of another program is shown by its name there.
inline std::string support_path(const RotorKit& kit, std::size_t support) {
  const std::string& name = kit.supports[support].name;
  return name.empty() ? "rotor.supports." + std::to_string(support) : "rotor.file." + name;
}

}  // namespace rubsweep::model
