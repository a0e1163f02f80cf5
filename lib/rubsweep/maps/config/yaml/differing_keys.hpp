#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rubsweep::config::yaml {

/// Differences between two printed studies (see print_study), one line for each key, in the order of their
/// names: "rotor.mass_kg: 0.8 there, 0.81 here". A key that is missing in one study is "not set" there. Empty
/// where the studies are equal. Throws ConfigError where a text is not YAML.
std::vector<std::string> differing_keys(std::string_view there, std::string_view here);

}  // namespace rubsweep::config::yaml
