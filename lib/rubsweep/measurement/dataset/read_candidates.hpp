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

/// Reads a number, which is then known, or a list of two, the bounds of an interval; `logarithmic` is how
/// every part of an interval is equally likely. Leaves `target` as it is where the key is missing.
void read_spread(yaml::Section& section, std::string_view name, const model::Range& range, bool logarithmic,
                 diagnose::Spread& target);

/// Reads how the motions of a data set are measured: turns, sampling_rate_hz, probes, and what read_measuring
/// reads.
rubsweep::dataset::Measurement read_measurement(const yaml::Value& value);

/// Reads what is known of noise, of lines of other origin, and of gains: noise_share, backward_1x_share,
/// order_2_share, order_3_share, gain_error.
void read_measuring(const yaml::Value& value, diagnose::Measuring& measuring);

/// Candidates of a diagnosis, and what is known of the measurement beforehand.
struct CandidateFile {
  std::vector<diagnose::Candidate>
      candidates{};             ///< with their clearances; machine and speed come from elsewhere
  std::vector<double> prior{};  ///< probability of each, add up to 1
  std::optional<diagnose::Spread> eccentricity_m{};  ///< unbalance of the recorded machine; empty: not known
  diagnose::Measuring measuring{};                   ///< probes and readings come from the recording
};

/// The usual candidates, equally likely.
CandidateFile usual_candidate_file();

/// Reads clearance_m, eccentricity_m, candidates, prior and measurement; what is missing is as usual. `name`
/// stands for the file in messages. Throws ConfigError with every problem.
CandidateFile read_candidate_file_text(std::string_view text, const std::string& name);

/// Reads a list of candidates, each the word of a cause or a map with kind, name, clearance_m and the keys of
/// diagnose::unknown_rows that its stops have; other ranges are the usual ones. `of_any_rotor`: with those
/// that only stops of a rotor kit have.
std::vector<diagnose::Candidate> read_candidates(const yaml::Value& value, bool of_any_rotor);

}  // namespace rubsweep::config::dataset
