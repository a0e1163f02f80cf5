#pragma once

#include <vector>

#include "rubsweep/config/yaml/value.hpp"
#include "rubsweep/diagnose/candidate.hpp"

namespace rubsweep::config::dataset {

/// Reads a list of candidates, each the word of a cause or a map with kind, name, clearance_m and the keys of
/// diagnose::unknown_rows that its stops have; other ranges are the usual ones.
std::vector<diagnose::Candidate> read_candidates(const yaml::Value& value);

}  // namespace rubsweep::config::dataset
