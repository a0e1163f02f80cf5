#pragma once

#include <stdexcept>
#include <string>

namespace rubsweep::fuzz {

/// Result for a configuration.
enum class Ending {
  refused,  ///< refused by the reader, which gives a place for every problem
  /// refused by the preparation: each number is allowed, but the cell cannot be computed with all of them
  no_plan,
  evaluated  ///< evaluated to a row, whatever its status is
};

/// A part of the path from a file to a row has violated its contract.
struct BrokenContract : std::logic_error {
  using std::logic_error::logic_error;
};

/// Takes a configuration from its text through preparation, explanation and one cell to a line of the map.
/// Bad input may end in a ConfigError with a message; everything else must end in a row. Throws
/// BrokenContract otherwise; exceptions of the library other than ConfigError are passed on.
Ending check_whole_path(const std::string& text);

}  // namespace rubsweep::fuzz
