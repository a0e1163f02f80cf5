#pragma once

#include <vector>

#include "rubsweep/config/yaml/value.hpp"
#include "rubsweep/diagnose/candidate.hpp"

namespace rubsweep::config::dataset {

/// Reads a list of candidates, each the word of a cause or a map with kind, name, weight, clearance_m and the
/// keys of diagnose::unknown_rows that its stops have. `usual` makes the ranges that a candidate does not
/// say.
std::vector<diagnose::Candidate> read_candidates(const yaml::Value& value,
                                                 diagnose::Candidate (*usual)(diagnose::Cause));

}  // namespace rubsweep::config::dataset
