#pragma once

/// \file
/// Errors. Everything in the library throws exceptions derived from std::exception, with a text that a person
/// can read:
///
/// | exception | cause | exit code of the programs |
/// |---|---|---|
/// | ConfigError | a number, a key, a file or a combination that cannot be simulated | 2 |
/// | IoError | a file that cannot be read or written, or that was damaged after it was written | 3 |
/// | LockedError | another process is at work in the directory | 6 |
/// | SolverError | a contract inside the library does not hold: please report it | 4 |
///
/// A cell that fails to integrate throws nothing: its outcome says why (settle.hpp).
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
