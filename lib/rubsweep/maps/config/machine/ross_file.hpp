#pragma once

#include <vector>

#include "rubsweep/core/model/rotor_kit.hpp"
#include "rubsweep/maps/config/keys/form.hpp"
#include "rubsweep/maps/config/yaml/section.hpp"

namespace rubsweep::config::machine {

/// The keys of `rotor` beside kind: ross: `file`, a TOML or JSON file of ROSS (github.com/petrobras/ross),
/// its name relative to the file that names it; `unbalance`, a list of discs by their tags; and of those of a
/// rotor kit what such a file does not say (read_kit_rest). The result is a rotor kit with the elements of
/// the file.
model::RotorKit read_ross_rotor(yaml::Section& section);
std::vector<keys::Key> ross_keys();

}  // namespace rubsweep::config::machine
