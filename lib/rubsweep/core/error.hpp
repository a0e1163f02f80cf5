#pragma once

#include <stdexcept>

namespace rubsweep {

/// An error that the user must correct: a value, a file or a combination that cannot be simulated. Exit code
/// 2.
class ConfigError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// An internal contract is violated: an error of this program. Never thrown for a cell that merely fails to
/// integrate; such a cell is a row with a status (see integrate/run/outcome.hpp).
class SolverError : public std::logic_error {
  using std::logic_error::logic_error;
};

/// Another process works in the same directory. Programs exit with 6.
class LockedError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A file could not be read or written. Programs exit with 3.
class IoError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace rubsweep
