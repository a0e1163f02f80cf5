#pragma once

/// \file
/// Errors. Everything here throws an exception that is derived from std::exception, and its text is for a
/// person:
///
/// | exception | cause | exit code of the programs |
/// |---|---|---|
/// | ConfigError | a number, a key, a file or a combination that cannot be simulated | 2 |
/// | IoError | a file that cannot be read or written, or is not as it was written | 3 |
/// | LockedError | another process is at work in the directory | 6 |
/// | SolverError | a contract inside the library does not hold: please report it | 4 |
///
/// A cell that fails to integrate is no exception: its outcome says so (settle.hpp).
///
/// ```cpp
/// using namespace rubsweep;
/// try {
///   config::read_run_config_text("rotor: {kind: jeffcot}", "my.yaml", {});
/// } catch (const ConfigError& error) {
///   std::puts(error.what());  // ... 'jeffcot' is unknown (did you mean 'jeffcott'?)
/// }
/// ```

#include "rubsweep/core/error.hpp"
