#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "rubsweep/measurement/diagnose/drawn_machine.hpp"
#include "rubsweep/measurement/diagnose/random_stream.hpp"

namespace rubsweep::diagnosis {

/// A rotor with the uncertainty of its parameters.
struct DiagnosedMachine {
  diagnose::FixedNumbers fixed{};
  diagnose::Spread natural_frequency_hz{}, damping_ratio{};  ///< intervals of a Jeffcott rotor
  std::optional<diagnose::Spread> eccentricity_m{};          ///< of the unbalance, if the files tell it
  std::vector<std::string> remarks{};                        ///< sources of intervals other than the file
  std::string text{};                                        ///< text of all files as they were read
  std::vector<model::RotorKit> kits{};                       ///< rotor kits whose unknown numbers were drawn
};

/// Reads the configuration of a machine, and the intervals in parameters.csv and correlation.csv that rubfit
/// wrote into the same directory, or those in the configuration (config/intervals.hpp). Numbers without an
/// interval are known to 1 % (natural frequencies) and 20 % (damping). Rotor kits are drawn from the
/// intervals with `seed`. Throws ConfigError where a Jeffcott rotor has no damping, where gravity acts, or
/// where diagnose::refuse_unscalable refuses a kit, and IoError.
DiagnosedMachine read_diagnosed_machine(const std::filesystem::path& file, std::uint64_t seed);

/// Makes the known kit from the drawn kits at the speed of the recording; does nothing for a Jeffcott rotor.
/// Throws ConfigError like diagnose::known_kit.
void prepare_kits(const std::filesystem::path& file, double speed_hz, DiagnosedMachine& diagnosed);

}  // namespace rubsweep::diagnosis
