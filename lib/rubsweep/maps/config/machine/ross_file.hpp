#pragma once

#include <vector>

#include "rubsweep/core/model/rotor_kit.hpp"
#include "rubsweep/maps/config/keys/form.hpp"
#include "rubsweep/maps/config/yaml/section.hpp"

namespace rubsweep::config::machine {

/// Reads the keys of `rotor` for kind: ross. `file` names a TOML or JSON file of ROSS
/// (github.com/petrobras/ross), relative to the file of the configuration. `unbalance` is a list of discs by
/// their tags. The remaining keys are those that a rotor kit has but a ROSS file does not (read_kit_rest).
/// The result is a rotor kit with the elements of the file.
model::RotorKit read_ross_rotor(yaml::Section& section);
std::vector<keys::Key> ross_keys();

}  // namespace rubsweep::config::machine
