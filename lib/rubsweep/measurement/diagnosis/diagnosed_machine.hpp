#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "rubsweep/measurement/diagnose/drawn_machine.hpp"
#include "rubsweep/measurement/diagnose/random_stream.hpp"

namespace rubsweep::diagnosis {

/// A rotor as far as it is known.
struct DiagnosedMachine {
  diagnose::FixedNumbers fixed{};
  diagnose::Spread natural_frequency_hz{}, damping_ratio{};  ///< intervals of a Jeffcott rotor
  std::optional<diagnose::Spread> eccentricity_m{};          ///< unbalance, where it was fitted
  std::vector<std::string> remarks{};                        ///< sources of intervals that are not the file's
  std::string text{};                                        ///< all files, as they were read
  std::vector<model::RotorKit> kits{};  ///< draws of a rotor kit: its unknown numbers vary
};

/// Reads the configuration of a machine and the intervals that rubfit left in parameters.csv and
/// correlation.csv beside it; without these 1 % of the natural frequencies and 20 % of the damping. A rotor
/// kit is drawn from them, `seed` is that of the draws. Throws ConfigError where a Jeffcott rotor has no
/// damping, gravity acts, or diagnose::refuse_unscalable refuses a kit, and IoError.
DiagnosedMachine read_diagnosed_machine(const std::filesystem::path& file, std::uint64_t seed);

/// Makes the drawn kits known at the speed of the recording; nothing of a Jeffcott rotor. Throws ConfigError
/// as diagnose::known_kit.
void prepare_kits(const std::filesystem::path& file, double speed_hz, DiagnosedMachine& diagnosed);

}  // namespace rubsweep::diagnosis
