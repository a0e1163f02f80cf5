#include "rubsweep/measurement/dataset/labels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "rubsweep/maps/batch/csv_table.hpp"

namespace rubsweep::dataset {
namespace {

using diagnose::Cause;
using diagnose::Unknown;

struct Column {
  LabelColumn column;
  std::string (*text)(const DataStudy&, const LabelledRecording&);
};

std::string number(double value) { return batch::csv_number(value); }

bool touches(const DataStudy& study, const LabelledRecording& recording) {
  return study.candidates[recording.candidate].cause != Cause::no_rub;
}

/// Value of a parameter that only machines with stops have; an empty cell for machines without stops.
template <Unknown unknown>
std::string of_stop(const DataStudy& study, const LabelledRecording& recording) {
  return touches(study, recording) ? number(value_of(recording.values, unknown)) : "";
}

std::string of_kick(const LabelledRecording& recording, double value) {
  return recording.motion.kicked ? number(value) : "";
}

double within_a_turn(double angle_deg) { return angle_deg - 360 * std::floor(angle_deg / 360); }

template <Unknown unknown, Cause cause>
std::string of_cause(const DataStudy& study, const LabelledRecording& recording) {
  return study.candidates[recording.candidate].cause == cause ? number(value_of(recording.values, unknown))
                                                              : "";
}

using S = const DataStudy&;
using R = const LabelledRecording&;

std::vector<Column> recording_columns() {
  return {
      {{"recording", "number of the recording, from 0"}, [](S, R r) { return std::to_string(r.index); }},
      {{"file", "its file"}, [](S s, R r) { return file_of(s, r); }},
      {{"split", "part of the set, by machine: no machine is in two of them"},
       [](S, R r) { return std::string(r.part); }},
      {{"machine", "number of the machine, from 0"}, [](S, R r) { return std::to_string(r.machine); }},
      {{"cause", "stops that the machine has"},
       [](S s, R r) { return std::string(to_string(s.candidates[r.candidate].cause)); }},
      {{"candidate", "name of the candidate in the study"},
       [](S s, R r) { return s.candidates[r.candidate].name; }},
      {{"rubs", "1: a stop is touched in the recording"},
       [](S, R r) { return std::string(r.motion.rubs ? "1" : "0"); }},
      {{"class", "class of the settled motion, as in map.csv"},
       [](S, R r) { return std::string(to_string(r.motion.motion_class)); }},
      {{"order", "turns of its period, of a motion that touches and repeats"},
       [](S, R r) { return r.motion.order ? std::to_string(*r.motion.order) : std::string(); }},
      {{"proof", "evidence for the class, as in map.csv; empty: none"},
       [](S, R r) { return r.motion.proof ? std::string(to_string(*r.motion.proof)) : std::string(); }},
      {{"speed_hz", "shaft speed"}, [](S, R r) { return number(r.speed_hz); }},
  };
}

std::vector<Column> machine_columns() {
  return {
      {{"mass_kg", "mass of the rotor"}, [](S s, R) { return number(s.fixed.rotor_mass_kg); }},
      {{"natural_frequency_hz", "natural frequency of the rotor"},
       [](S, R r) { return number(value_of(r.values, Unknown::natural_frequency)); }},
      {{"damping_ratio", "damping ratio of the rotor"},
       [](S, R r) { return number(value_of(r.values, Unknown::damping_ratio)); }},
      {{"eccentricity_m", "eccentricity of the unbalance"},
       [](S, R r) { return number(r.motion.eccentricity_m); }},
      {{"whirl_ratio", "largest excursion of the quiet whirl over the clearance left"},
       [](S s, R r) { return touches(s, r) ? number(r.motion.whirl_ratio) : std::string(); }},
      {{"clearance_m", "clearance of the first stop"},
       [](S s, R r) { return touches(s, r) ? number(r.clearance_m) : std::string(); }},
      {{"stiffness_n_per_m", "stiffness of the contact"}, of_stop<Unknown::stiffness>},
      {{"restitution", "nominal restitution of the contact"}, of_stop<Unknown::restitution>},
      {{"friction_coefficient", "coefficient of dry friction"}, of_stop<Unknown::friction>},
      {{"casing_mass_kg", "mass behind each stop"}, of_stop<Unknown::casing_mass>},
      {{"casing_frequency_hz", "natural frequency of that mass on its mount"},
       of_stop<Unknown::casing_frequency>},
      {{"casing_damping_ratio", "damping ratio of that mass on its mount"},
       [](S s, R r) { return touches(s, r) ? number(s.fixed.casing_damping_ratio) : std::string(); }},
      {{"contact_radius_m", "radius of the shaft where it rubs"},
       [](S s, R r) { return touches(s, r) ? number(s.fixed.contact_radius_m) : std::string(); }},
      {{"second_clearance_ratio", "clearance of the second stop over that of the first"},
       of_cause<Unknown::second_clearance_ratio, Cause::two_sides>},
      {{"offset_ratio", "offset of an annular stop over its clearance"},
       of_cause<Unknown::offset_ratio, Cause::annular_offset>},
      {{"stop_angle_deg",
        "direction of the first stop, of an offset that of the narrowest gap, from +x to +y"},
       [](S s, R r) {
         const Cause cause = s.candidates[r.candidate].cause;
         return touches(s, r) && cause != Cause::annular ? number(r.stop_angle_deg) : std::string();
       }},
  };
}

std::vector<Column> motion_columns() {
  return {
      {{"kick_ratio",
        "velocity that the kick gave, over clearance times natural angular frequency; empty: no kick"},
       [](S, R r) { return of_kick(r, value_of(r.values, Unknown::kick_ratio)); }},
      {{"kick_angle_deg", "direction of the kick, from +x to +y"},
       [](S, R r) {
         return of_kick(r, within_a_turn(r.stop_angle_deg + value_of(r.values, Unknown::kick_angle)));
       }},
      {{"kick_phase_deg", "turn of the shaft from the smallest gap at the first stop to the kick"},
       [](S, R r) { return of_kick(r, value_of(r.values, Unknown::kick_phase)); }},
      {{"contact_fraction", "share of the time in contact"},
       [](S, R r) { return number(r.motion.contact.contact_fraction); }},
      {{"peak_force_n", "largest normal force at one stop"},
       [](S, R r) { return number(r.motion.contact.peak_contact_force_n); }},
      {{"noise_m", "standard deviation of the white noise of every reading"},
       [](S, R r) { return number(r.noise_m); }},
      {{"mark_deg", "turn of the shaft from the first reading until the mark comes to the keyphasor"},
       [](S, R r) { return number(360 * r.mark_turns); }},
      {{"gain_x", "gain of the probe in x, 1 being right"}, [](S, R r) { return number(r.gain[0]); }},
      {{"gain_y", "gain of the probe in y"},
       [](S, R r) { return r.gain.size() > 1 ? number(r.gain[1]) : std::string(); }},
      {{"penetration_ratio",
        "largest force over the stiffness of the contact, over the smallest clearance, in the recording"},
       [](S s, R r) { return touches(s, r) ? number(r.penetration_ratio) : std::string(); }},
      {{"force_ratio", "largest normal force at one stop over the weight of the rotor, in the recording"},
       [](S s, R r) { return touches(s, r) ? number(r.force_ratio) : std::string(); }},
      {{"sha256", "SHA-256 of its file"}, [](S, R r) { return r.sha256; }},
      {{"exponent", "exponent of the penetration in the force of the contact; 1: a spring"},
       of_stop<Unknown::exponent>},
      {{"peak_acceleration_m_per_s2",
        "largest acceleration of the rotor in the recording, from 128 points a turn"},
       [](S, R r) { return number(r.peak_acceleration_m_per_s2); }},
      {{"other_cause", "kinds of vibrations of another cause, joined by +, which replace the quiet whirl"},
       [](S, R r) { return r.other_cause; }},
  };
}

const std::vector<Column>& columns() {
  static const std::vector<Column> all = [] {
    std::vector<Column> columns = recording_columns();
    std::ranges::move(machine_columns(), std::back_inserter(columns));
    std::ranges::move(motion_columns(), std::back_inserter(columns));
    return columns;
  }();
  return all;
}

std::string text_of(const diagnose::Spread& spread) {
  if (spread.low == spread.high) return batch::csv_number(spread.low);
  std::string text = fmt::format("{} to {}{}", batch::csv_number(spread.low), batch::csv_number(spread.high),
                                 spread.logarithmic ? ", evenly in the logarithm" : "");
  if (spread.at_low > 0) text += fmt::format(", in {:g} % the lowest", 100 * spread.at_low);
  return text;
}

std::string ranges_of(const diagnose::Candidate& candidate) {
  std::string text;
  for (const diagnose::UnknownRow& row : diagnose::unknown_rows())
    if (row.unknown != Unknown::exponent || spread_of(candidate, row.unknown).high > 1)
      fmt::format_to(std::back_inserter(text), "  {}: {}\n", row.key,
                     text_of(spread_of(candidate, row.unknown)));
  fmt::format_to(std::back_inserter(text), "  clearance_m: {}\n", text_of(candidate.clearance_m));
  return text;
}

}  // namespace

std::vector<LabelColumn> label_columns() {
  std::vector<LabelColumn> result;
  for (const Column& column : columns()) result.push_back(column.column);
  return result;
}

std::string label_header() {
  std::vector<std::string> names;
  for (const Column& column : columns()) names.emplace_back(column.column.name);
  return batch::csv_row(names);
}

std::string label_line(const DataStudy& study, const LabelledRecording& recording) {
  std::vector<std::string> cells;
  for (const Column& column : columns()) cells.push_back(column.text(study, recording));
  return batch::csv_row(cells);
}

std::string file_of(const DataStudy& study, const LabelledRecording& recording) {
  return fmt::format("{}/{:06}.{}", recording.part, recording.index,
                     study.format == Format::csv ? "csv" : "mat");
}

std::string study_text(const DataStudy& study) {
  const Measurement& read = study.measurement;
  std::string text = fmt::format(
      "recordings: {}\nrecordings_per_machine: {}\nseed: {}\nmass_kg: {}\ncontact_radius_m: {}\n"
      "casing_damping_ratio: {}\nspeed_ratio: {}\nrub.penetration_ratio: {}\nrub.force_ratio: {}\n"
      "turns: {}\nsampling_rate_hz: {}\nprobes: {}\n"
      "noise_share: {}\nbackward_1x_share: {}\norder_2_share: {}\norder_3_share: {}\ngain_error: {}\n"
      "training: {}\nvalidation: {}\ntest: {}\nformat: {}\n",
      study.recordings, study.recordings_per_machine, study.seed, study.fixed.rotor_mass_kg,
      study.fixed.contact_radius_m, study.fixed.casing_damping_ratio, text_of(study.speed_ratio),
      study.rub.penetration_ratio, study.rub.force_ratio, read.turns, read.sampling_rate_hz, read.probes,
      text_of(read.noise_share), read.other_lines.backward_1x, read.other_lines.order_2,
      read.other_lines.order_3, read.gain_error, study.split.training, study.split.validation,
      study.split.test, to_string(study.format));
  if (study.other_causes_share > 0) text += fmt::format("other_causes_share: {}\n", study.other_causes_share);
  for (const diagnose::Candidate& candidate : study.candidates)
    fmt::format_to(std::back_inserter(text), "candidate {} ({}):\n{}", candidate.name,
                   to_string(candidate.cause), ranges_of(candidate));
  return text;
}

}  // namespace rubsweep::dataset
