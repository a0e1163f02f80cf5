#include "rubsweep/measurement/dataset/read_candidates.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "rubsweep/maps/config/file.hpp"
#include "rubsweep/maps/config/yaml/text.hpp"

namespace rubsweep::config::dataset {
namespace {

using diagnose::Candidate;
using diagnose::Cause;
using diagnose::Unknown;

constexpr model::Range any_share{.low = 0, .high = 1}, noise{.low = 0, .high = 1, .low_open = true};
/// Allowed sampling rates, Hz; above 1 MHz, times written with twelve digits would no longer differ.
constexpr model::Range rate_hz{.low = 0, .high = 1e6, .low_open = true};

void read_disturbances(yaml::Section& section, diagnose::Spread& noise_share, diagnose::OtherLines& lines,
                       double& gain_error) {
  read_spread(section, "noise_share", noise, true, noise_share);
  section.field("backward_1x_share", lines.backward_1x, any_share);
  section.field("order_2_share", lines.order_2, any_share);
  section.field("order_3_share", lines.order_3, any_share);
  section.field("gain_error", gain_error, any_share);
}

constexpr std::string_view candidate_file_form =
    "a map with clearance_m, eccentricity_m, candidates, prior, measurement";
/// Usual clearances, from a labyrinth seal of a small machine to the screw of a rotor kit.
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
    file.prior = diagnose::usual_prior(file.candidates);
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
  return file;
}

/// Whether a file of candidates may give this number for stops of this kind.
bool has(Cause cause, const diagnose::UnknownRow& row) {
  if (!row.of_file || cause == Cause::no_rub) return false;
  if (row.unknown == Unknown::second_clearance_ratio) return cause == Cause::two_sides;
  if (row.unknown == Unknown::offset_ratio) return cause == Cause::annular_offset;
  return true;
}

/// Reads the name, which becomes a cell of a table. A name that begins like a formula is refused, because a
/// spreadsheet program would compute it.
void read_name(const yaml::Value& value, std::string& name) {
  const auto text = yaml::read_text(value);
  if (!text) return;
  if (std::ranges::any_of(*text, yaml::is_control)) {
    yaml::refuse(value, "is no name", "one line of text");
  } else if (text->find_first_of("=+-@") == 0) {
    yaml::refuse(value, "is no name", "one line of text that does not begin with = + - @");
  } else {
    name = *text;
  }
}

std::optional<Candidate> read_candidate(const yaml::Value& value, bool of_any_rotor) {
  if (value.node.kind == yaml::Node::Kind::scalar) {
    const auto index = yaml::read_word(value, diagnose::cause_words.texts);
    if (!index) return std::nullopt;
    return diagnose::usual_candidate(diagnose::all_causes[*index]);
  }
  yaml::Section section(value, "the word of a kind, or a map with kind and ranges");
  const auto index = section.require_kind("kind", diagnose::cause_words.texts);
  if (!index) {
    section.allow_unknown_keys();
    return std::nullopt;
  }
  Candidate candidate = diagnose::usual_candidate(diagnose::all_causes[*index]);
  if (const auto name = section.find("name")) read_name(*name, candidate.name);
  if (candidate.cause != Cause::no_rub)
    read_spread(section, "clearance_m", model::positive, true, candidate.clearance_m);
  for (const diagnose::UnknownRow& row : diagnose::unknown_rows())
    if (has(candidate.cause, row))
      read_spread(section, row.key, row.range, row.logarithmic, spread_of(candidate, row.unknown));
  if (of_any_rotor && candidate.cause != Cause::no_rub && section.find("position_m"))
    read_spread(section, "position_m", model::not_negative, false, candidate.position_m.emplace());
  return candidate;
}

}  // namespace

void read_spread(yaml::Section& section, std::string_view name, const model::Range& range, bool logarithmic,
                 diagnose::Spread& target) {
  const auto value = section.find(name);
  if (!value) return;
  if (value->node.kind != yaml::Node::Kind::list) {
    if (const auto number = yaml::read_number(*value, range)) target = {*number, *number, false};
    return;
  }
  std::array<double, 2> bounds{};
  if (!yaml::read_numbers(*value, bounds)) return;
  for (const double bound : bounds) {
    if (!model::contains(range, bound)) {
      yaml::refuse(*value, "goes out of range", "a number or [low, high], each " + model::describe(range));
      return;
    }
  }
  if (bounds[0] > bounds[1]) {
    yaml::refuse(*value, "begins above its end", "[low, high]");
    return;
  }
  if (logarithmic && bounds[0] <= 0) {
    yaml::refuse(*value, "begins at 0", "[low, high] above 0, for its logarithm is drawn evenly");
    return;
  }
  target = {bounds[0], bounds[1], logarithmic};
}

rubsweep::dataset::Measurement read_measurement(const yaml::Value& value) {
  yaml::Section section(value);
  rubsweep::dataset::Measurement measurement;
  section.field("turns", measurement.turns, yaml::IntegerRange{8, 1024});
  section.field("sampling_rate_hz", measurement.sampling_rate_hz, rate_hz);
  section.field("probes", measurement.probes, yaml::IntegerRange{1, 2});
  read_disturbances(section, measurement.noise_share, measurement.other_lines, measurement.gain_error);
  return measurement;
}

void read_measuring(const yaml::Value& value, diagnose::Measuring& measuring) {
  yaml::Section section(value);
  read_disturbances(section, measuring.noise_share, measuring.other_lines, measuring.gain_error);
  section.field("free_vibration_share", measuring.free_vibration, any_share);
}

CandidateFile usual_candidate_file() {
  CandidateFile file{.candidates = diagnose::usual_candidates()};
  for (diagnose::Candidate& candidate : file.candidates) candidate.clearance_m = usual_clearance_m;
  file.prior = diagnose::usual_prior(file.candidates);
  return file;
}

CandidateFile read_candidate_file_text(std::string_view text, const std::string& name) {
  return read_parsed(text, name, candidate_file_form, {}, read_file_root);
}

std::vector<Candidate> read_candidates(const yaml::Value& value, bool of_any_rotor) {
  constexpr std::size_t most = 20;
  std::vector<Candidate> candidates;
  for (const yaml::Value& item : yaml::read_list(value, most)) {
    auto candidate = read_candidate(item, of_any_rotor);
    if (!candidate) continue;
    if (std::ranges::count(candidates, candidate->name, &Candidate::name) > 0)
      yaml::refuse(item, "has the name '" + candidate->name + "' as another candidate", "a name of its own");
    candidates.push_back(*std::move(candidate));
  }
  return candidates;
}

}  // namespace rubsweep::config::dataset
