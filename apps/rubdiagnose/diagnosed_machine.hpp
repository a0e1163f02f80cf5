#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "rubsweep/diagnose/drawn_machine.hpp"
#include "rubsweep/diagnose/spread.hpp"

namespace rubsweep::apps {

/// A rotor as far as it is known.
struct DiagnosedMachine {
  diagnose::FixedNumbers fixed{};
  diagnose::Spread natural_frequency_hz{}, damping_ratio{};  ///< of a Jeffcott rotor
  std::optional<diagnose::Spread> eccentricity_m{};          ///< unbalance, where it was fitted
  std::vector<std::string> remarks{};  ///< where an interval comes from when it is not the file's
  std::string text{};                  ///< of all files that were read
};

/// Reads the configuration of a machine and the intervals that rubfit left in parameters.csv and
/// correlation.csv beside it; without these 1 % of the natural frequencies and 20 % of the damping. A rotor
/// kit is drawn from them; `speed_hz` is that of the recording, `seed` that of the draws. Throws ConfigError
/// where the rotor has no damping, gravity acts, or diagnose::known_kit refuses it, and IoError.
DiagnosedMachine read_diagnosed_machine(const std::filesystem::path& file, double speed_hz,
                                        std::uint64_t seed);

}  // namespace rubsweep::apps
