#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "rubsweep/measurement/diagnose/inference/case_set.hpp"

namespace rubsweep::diagnose::inference {

/// Speed that motions are simulated at for a recording at this one: the nearest of a grid with steps of half
/// a percent, so that recordings of one machine that runs steadily share their cases.
double simulated_speed_hz(double speed_hz);

/// Digest of all that decides the cases of the priors: machine, candidates, speed, turns, seed, number, and
/// the code that simulates. Nothing of the instrument does.
std::string cases_digest(const DiagnosisProblem& problem, const CaseOptions& options);

/// Writes cases of the priors into DIRECTORY/DIGEST.cases, whole or not at all. Throws IoError.
void keep_cases(const std::filesystem::path& directory, const std::string& digest, const CaseSet& set);

/// Reads them back; empty where there are none, or the file is not whole.
std::optional<CaseSet> kept_cases(const std::filesystem::path& directory, const std::string& digest,
                                  const DiagnosisProblem& problem);

}  // namespace rubsweep::diagnose::inference
