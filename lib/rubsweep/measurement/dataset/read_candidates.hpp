#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "rubsweep/maps/config/yaml/section.hpp"
#include "rubsweep/maps/config/yaml/value.hpp"
#include "rubsweep/measurement/dataset/data_study.hpp"
#include "rubsweep/measurement/diagnose/candidate.hpp"
#include "rubsweep/measurement/diagnose/observed_lines.hpp"
#include "rubsweep/measurement/diagnose/random_stream.hpp"

namespace rubsweep::config::dataset {

/// Reads a single number, which counts as known, or the two bounds of an interval. `logarithmic`: the
/// logarithm is uniformly distributed between the bounds. Leaves `target` unchanged where the key is missing.
void read_spread(yaml::Section& section, std::string_view name, const model::Range& range, bool logarithmic,
                 diagnose::Spread& target);

/// Reads how the motions of a data set are measured: turns, sampling_rate_hz, probes, and the keys of
/// read_measuring without free_vibration_share.
rubsweep::dataset::Measurement read_measurement(const yaml::Value& value);

/// Reads the prior knowledge of noise, lines of other origin and probe gains: noise_share, backward_1x_share,
/// order_2_share, order_3_share, gain_error, free_vibration_share.
void read_measuring(const yaml::Value& value, diagnose::Measuring& measuring);

/// Candidates of a diagnosis, and the prior knowledge of the measurement.
struct CandidateFile {
  std::vector<diagnose::Candidate>
      candidates{};             ///< candidates with their clearances; machine and speed come from other files
  std::vector<double> prior{};  ///< probability of each candidate; they add up to 1
  std::optional<diagnose::Spread> eccentricity_m{};  ///< unbalance of the recorded machine; empty: not known
  diagnose::Measuring measuring{};                   ///< probes and readings come from the recording
};

CandidateFile usual_candidate_file();  ///< The usual candidates with their usual prior.

/// Reads clearance_m, eccentricity_m, candidates, prior and measurement; a missing key has its usual value.
/// `name` stands for the file in messages. Throws ConfigError with every problem.
CandidateFile read_candidate_file_text(std::string_view text, const std::string& name);

/// Reads a list of candidates. Each entry is the name of a cause, or a map with kind, name, clearance_m and
/// those keys of diagnose::unknown_rows that the candidate's stops have. Missing keys have their usual
/// ranges. `of_any_rotor`: keys that only stops of a rotor kit have are allowed, too.
std::vector<diagnose::Candidate> read_candidates(const yaml::Value& value, bool of_any_rotor);

}  // namespace rubsweep::config::dataset
