#include "rubsweep/measurement/dataset/data_study.hpp"

#include <cmath>

#include "rubsweep/maps/config/file.hpp"
#include "rubsweep/maps/config/yaml/section.hpp"
#include "rubsweep/measurement/dataset/read_candidates.hpp"

namespace rubsweep::config::dataset {
namespace {

using diagnose::Spread;
using diagnose::Unknown;
using rubsweep::dataset::DataStudy;
using rubsweep::dataset::Format;
using rubsweep::dataset::RubBounds;
using rubsweep::dataset::Split;

constexpr std::string_view root_form =
    "a map with recordings, machine, candidates, measurement, split, format, output";
constexpr model::Range share{.low = 0, .high = 1};

/// Ranges of the machine parameters that all candidates share.
struct MachineRanges {
  Spread natural_frequency_hz{20, 60, false}, damping_ratio{0.01, 0.04, true}, clearance_m{5e-5, 1e-3, true};
};

MachineRanges read_machine(const yaml::Value& value, diagnose::FixedNumbers& fixed) {
  yaml::Section section(value);
  MachineRanges ranges;
  section.field("mass_kg", fixed.rotor_mass_kg, model::positive);
  section.field("contact_radius_m", fixed.contact_radius_m, model::not_negative);
  section.field("casing_damping_ratio", fixed.casing_damping_ratio, model::not_negative);
  read_spread(section, "natural_frequency_hz", model::positive, false, ranges.natural_frequency_hz);
  read_spread(section, "damping_ratio", model::positive, true, ranges.damping_ratio);
  read_spread(section, "clearance_m", model::positive, true, ranges.clearance_m);
  return ranges;
}

RubBounds read_rub(const yaml::Value& value) {
  yaml::Section section(value);
  RubBounds rub;
  section.field("penetration_ratio", rub.penetration_ratio, model::positive);
  section.field("force_ratio", rub.force_ratio, model::positive);
  return rub;
}

Split read_split(const yaml::Value& value) {
  yaml::Section section(value);
  Split split;
  section.field("training", split.training, share);
  section.field("validation", split.validation, share);
  section.field("test", split.test, share);
  section.refuse_unknown_keys();
  constexpr double rounding = 1e-9;
  if (section.is_sound() && std::abs(split.training + split.validation + split.test - 1) > rounding)
    section.refuse_together("test", {"training", "validation", "test"},
                            "makes the shares add up to another number", "three shares that add up to 1");
  return split;
}

constexpr double fewest_readings = 5;  ///< Fewest readings per turn: with fewer, 2X would be aliased.

void check_rate(const yaml::Section& section, const DataStudy& study, const MachineRanges& machine) {
  const double fastest_hz = study.speed_ratio.high * machine.natural_frequency_hz.high;
  if (study.measurement.sampling_rate_hz < fewest_readings * fastest_hz)
    section.refuse_together("measurement", {"measurement", "speed_ratio", "machine"},
                            "reads fewer than 5 times in a turn of the fastest shaft",
                            "a sampling_rate_hz of 5 speed_ratio natural_frequency_hz or more");
}

DataStudy read_root(const yaml::Value& root) {
  yaml::Section section(root, root_form);
  DataStudy study;
  MachineRanges machine;
  section.field("recordings", study.recordings, yaml::IntegerRange{1, 10'000'000});
  section.field("recordings_per_machine", study.recordings_per_machine, yaml::IntegerRange{1, 1'000'000});
  long seed = 1;
  section.field("seed", seed, yaml::IntegerRange{0, 1'000'000'000});
  study.seed = static_cast<std::uint64_t>(seed);
  if (const auto value = section.find("machine")) machine = read_machine(*value, study.fixed);
  read_spread(section, "speed_ratio", model::positive, false, study.speed_ratio);
  study.candidates = diagnose::usual_candidates();
  if (const auto value = section.find("candidates")) study.candidates = read_candidates(*value, false);
  for (diagnose::Candidate& candidate : study.candidates) {
    spread_of(candidate, Unknown::natural_frequency) = machine.natural_frequency_hz;
    spread_of(candidate, Unknown::damping_ratio) = machine.damping_ratio;
    if (candidate.clearance_m.high == 0) candidate.clearance_m = machine.clearance_m;
  }
  section.field("other_causes_share", study.other_causes_share, share);
  if (const auto value = section.find("rub")) study.rub = read_rub(*value);
  if (const auto value = section.find("measurement")) study.measurement = read_measurement(*value);
  if (const auto value = section.find("split")) study.split = read_split(*value);
  section.field("format", study.format, words_of<Format>());
  if (const auto value = section.require("output", "a map")) study.directory = read_output(*value);
  section.refuse_unknown_keys();
  if (section.is_sound()) check_rate(section, study, machine);
  return study;
}

}  // namespace

DataStudy read_data_study_text(std::string_view text, const std::string& name) {
  return read_parsed(text, name, root_form, {}, read_root);
}

}  // namespace rubsweep::config::dataset
