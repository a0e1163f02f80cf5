#include "rubsweep/config/dataset/read_candidate_file.hpp"

#include <cstddef>

#include "rubsweep/config/dataset/read_candidates.hpp"
#include "rubsweep/config/dataset/read_measurement.hpp"
#include "rubsweep/config/dataset/spread_field.hpp"
#include "rubsweep/config/file.hpp"
#include "rubsweep/config/yaml/section.hpp"

namespace rubsweep::config::dataset {
namespace {

constexpr std::string_view candidate_file_form =
    "a map with clearance_m, eccentricity_m, candidates, prior, measurement";
/// From a labyrinth seal of a small machine to the screw of a rotor kit.
constexpr diagnose::Spread usual_clearance_m{5e-5, 1e-3, true};

void read_prior(const yaml::Value& value, std::vector<double>& prior) {
  std::vector<double> shares(prior.size());
  if (!yaml::read_numbers(value, shares)) return;
  double sum = 0;
  for (const double share : shares) {
    if (!(share > 0)) {
      yaml::refuse(value, "has a share that is not above 0", "one number above 0 for each candidate");
      return;
    }
    sum += share;
  }
  for (std::size_t c = 0; c < prior.size(); ++c) prior[c] = shares[c] / sum;
}

CandidateFile read_file_root(const yaml::Value& root) {
  yaml::Section section(root, candidate_file_form);
  CandidateFile file = usual_candidate_file();
  if (const auto value = section.find("candidates")) {
    file.candidates = read_candidates(*value, true);
    if (file.candidates.size() < 2 && section.is_sound())
      yaml::refuse(*value, "has nothing to choose from", "two candidates or more");
    file.prior.assign(file.candidates.size(), 1.0 / static_cast<double>(file.candidates.size()));
  }
  diagnose::Spread clearance_m = usual_clearance_m;
  read_spread(section, "clearance_m", model::positive, true, clearance_m);
  diagnose::Spread eccentricity_m;
  read_spread(section, "eccentricity_m", model::positive, true, eccentricity_m);
  if (eccentricity_m.high > 0) file.eccentricity_m = eccentricity_m;
  const bool listed = section.find("candidates").has_value();
  for (diagnose::Candidate& candidate : file.candidates)
    if (!listed || candidate.clearance_m.high == 0) candidate.clearance_m = clearance_m;
  if (const auto value = section.find("prior")) read_prior(*value, file.prior);
  if (const auto value = section.find("measurement")) read_measuring(*value, file.measuring);
  section.refuse_unknown_keys();
  return file;
}

}  // namespace

CandidateFile usual_candidate_file() {
  CandidateFile file{.candidates = diagnose::usual_candidates()};
  for (diagnose::Candidate& candidate : file.candidates) candidate.clearance_m = usual_clearance_m;
  file.prior.assign(file.candidates.size(), 1.0 / static_cast<double>(file.candidates.size()));
  return file;
}

CandidateFile read_candidate_file_text(std::string_view text, const std::string& name) {
  yaml::Diagnostics diagnostics(name, {});
  const yaml::Node root = parse_config(text, name, candidate_file_form, {}, diagnostics);
  CandidateFile file = read_file_root({root, "", diagnostics});
  diagnostics.throw_if_any();
  return file;
}

}  // namespace rubsweep::config::dataset
