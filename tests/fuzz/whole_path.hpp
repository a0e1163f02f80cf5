#pragma once

#include <stdexcept>
#include <string>

namespace rubsweep::fuzz {

/// Fate of a configuration.
enum class Ending {
  refused,   ///< refusal by the reader, with a place for every problem
  no_plan,   ///< refusal by the preparation: numbers allowed each but not computable together
  evaluated  ///< to a row, whatever its status
};

/// Something on the way from a file to a row broke its contract.
struct BrokenContract : std::logic_error {
  using std::logic_error::logic_error;
};

/// Takes a configuration from its text through preparation, explanation and one cell to a line of the map.
/// Bad input may end in a ConfigError with a message, everything else in a row. Throws BrokenContract where
/// it does not; any other exception but ConfigError that comes out of the library passes through.
Ending check_whole_path(const std::string& text);

}  // namespace rubsweep::fuzz
