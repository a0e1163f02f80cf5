#pragma once

#include <string>

#include "rubsweep/config/ring/ring_config.hpp"

namespace rubsweep::config::ring {

/// The complete configuration as YAML, defaults included, that reads back as an equal one. Throws ConfigError
/// when the output directory is not UTF-8.
std::string print_ring_config(const RingConfig& config);

/// Digest of everything that decides the numbers, as study_digest.hpp.
std::string ring_study_digest(const rubsweep::ring::Study& study);

}  // namespace rubsweep::config::ring
