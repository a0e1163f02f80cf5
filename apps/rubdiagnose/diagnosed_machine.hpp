#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "rubsweep/diagnose/drawn_machine.hpp"
#include "rubsweep/diagnose/spread.hpp"

namespace rubsweep::apps {

/// A rotor as far as it is known.
struct DiagnosedMachine {
  diagnose::FixedNumbers fixed{};
  diagnose::Spread natural_frequency_hz{}, damping_ratio{};
  std::vector<std::string> remarks{};  ///< where an interval comes from when it is not the file's
};

/// Reads the configuration of a machine and the intervals that rubfit left in parameters.csv beside it;
/// without these 1 % of the natural frequency and 20 % of the damping ratio. Throws ConfigError where the
/// rotor is no Jeffcott rotor, has no damping, or feels gravity, and IoError.
DiagnosedMachine read_diagnosed_machine(const std::filesystem::path& file);

}  // namespace rubsweep::apps
