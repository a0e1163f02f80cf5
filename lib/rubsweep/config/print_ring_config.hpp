#pragma once

#include <string>

#include "rubsweep/config/ring_config.hpp"

namespace rubsweep::config {

/// The complete configuration as YAML, defaults included, that reads back as an equal one. Throws ConfigError
/// when the output directory is not UTF-8.
std::string print_ring_config(const RingConfig& config);

/// Digest of everything that decides the numbers, as study_digest.hpp.
std::string ring_study_digest(const ring::Study& study);

}  // namespace rubsweep::config
