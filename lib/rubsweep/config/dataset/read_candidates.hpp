#pragma once

#include <vector>

#include "rubsweep/config/yaml/value.hpp"
#include "rubsweep/diagnose/candidate.hpp"

namespace rubsweep::config::dataset {

/// Reads a list of candidates, each the word of a cause or a map with kind, name, clearance_m and the keys of
/// diagnose::unknown_rows that its stops have; other ranges are the usual ones. `of_any_rotor`: with those that
/// only stops of a rotor kit have.
std::vector<diagnose::Candidate> read_candidates(const yaml::Value& value, bool of_any_rotor);

}  // namespace rubsweep::config::dataset
