#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "rubsweep/measurement/diagnose/inference/case_set.hpp"

namespace rubsweep::diagnose::inference {

/// SHA-1 of the compiled libraries that simulate cases: kept cases are used by the same build only. Generated
/// by program_digest.cmake.
extern const char* const cases_version;

/// Speed at which motions are simulated for a recording at `speed_hz`: the nearest point of a grid with steps
/// of 0.5 %. Recordings of one steadily running machine then share their cases.
double simulated_speed_hz(double speed_hz);

/// Digest of all that decides the cases drawn from the priors: machine, candidates, speed, turns, seed,
/// number of cases, and the simulating code. The instrument does not enter.
std::string cases_digest(const DiagnosisProblem& problem, const CaseOptions& options);

/// Writes cases drawn from the priors into DIRECTORY/DIGEST.cases, whole or not at all. Throws IoError.
void keep_cases(const std::filesystem::path& directory, const std::string& digest, const CaseSet& set);

/// Reads the cases back; empty where there is no such file, or the file is not whole.
std::optional<CaseSet> kept_cases(const std::filesystem::path& directory, const std::string& digest,
                                  const DiagnosisProblem& problem);

}  // namespace rubsweep::diagnose::inference
