#include "rubsweep/measurement/dataset/labelled_recording.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>

#include "rubsweep/core/error.hpp"
#include "rubsweep/measurement/dataset/readings.hpp"
#include "rubsweep/measurement/diagnose/random_stream.hpp"

namespace rubsweep::dataset {
namespace {

using diagnose::Point;
using diagnose::RandomStream;
using diagnose::Unknown;

constexpr bool of_one_recording(Unknown unknown) {
  return unknown == Unknown::whirl_ratio || unknown == Unknown::kick_ratio ||
         unknown == Unknown::kick_angle || unknown == Unknown::kick_phase;
}

/// Sets how deep and how hard the stops are touched.
void measure_rub(const DataStudy& study, LabelledRecording& recording) {
  constexpr double gravity_m_per_s2 = 9.80665;
  const double force_n = recording.motion.contact.peak_contact_force_n;
  recording.penetration_ratio = penetration_ratio(study.candidates[recording.candidate].cause,
                                                  recording.values, recording.clearance_m, force_n);
  recording.force_ratio = force_n / (study.fixed.rotor_mass_kg * gravity_m_per_s2);
}

/// A motion with the numbers that are drawn until it runs and is no harder than a machine survives.
void draw_motion(const DataStudy& study, const MachineDraw& machine, LabelledRecording& recording,
                 response::motion::Workspace& workspace) {
  constexpr int most_draws = 300;
  const diagnose::Candidate& candidate = study.candidates[recording.candidate];
  RandomStream random(study.seed, recording.index, Purpose::of_recording);
  for (int draw = 0; draw < most_draws; ++draw) {
    Point unit = machine.unit;
    for (const diagnose::UnknownRow& row : diagnose::unknown_rows())
      if (of_one_recording(row.unknown)) unit[static_cast<std::size_t>(row.unknown)] = random.uniform();
    recording.values = values_at(candidate, unit);
    recording.speed_hz = value_at(study.speed_ratio, random.uniform()) *
                         value_of(recording.values, Unknown::natural_frequency);
    try {
      const auto motion = diagnose::simulate_motion(
          drawn_machine(candidate.cause, recording.values, recording.clearance_m, study.fixed),
          recording.speed_hz, scene::WhirlRatio{value_of(recording.values, Unknown::whirl_ratio)},
          study.measurement.turns, workspace);
      if (!motion) continue;
      recording.motion = *motion;
      measure_rub(study, recording);
      if (recording.penetration_ratio <= study.rub.penetration_ratio &&
          recording.force_ratio <= study.rub.force_ratio)
        return;
    } catch (const ConfigError&) {
      // Numbers that are each allowed, but not together.
    }
  }
  throw SolverError(
      "recording " + std::to_string(recording.index) +
      ": no draw could be simulated that stays within rub.penetration_ratio and rub.force_ratio");
}

}  // namespace

std::size_t candidate_of(const DataStudy& study, std::size_t machine) {
  return machine % study.candidates.size();
}

MachineDraw draw_machine(const DataStudy& study, std::size_t machine) {
  diagnose::RandomStream random(study.seed, machine, Purpose::of_machine);
  MachineDraw drawn;
  for (const diagnose::UnknownRow& row : diagnose::unknown_rows())
    if (!row.of_kit) drawn.unit[static_cast<std::size_t>(row.unknown)] = random.uniform();
  drawn.clearance_m = value_at(study.candidates[candidate_of(study, machine)].clearance_m, random.uniform());
  drawn.stop_angle_deg = 360 * random.uniform();
  drawn.mark_turns = random.uniform();
  const double place = random.uniform();
  drawn.part = place < study.split.training                            ? "training"
               : place < study.split.training + study.split.validation ? "validation"
                                                                       : "test";
  for (int probe = 0; probe < study.measurement.probes; ++probe)
    drawn.gain.push_back(1 + study.measurement.gain_error * random.normal());
  return drawn;
}

LabelledRecording make_recording(const DataStudy& study, std::size_t index,
                                 response::motion::Workspace& workspace) {
  LabelledRecording recording;
  recording.index = index;
  recording.machine = index / static_cast<std::size_t>(study.recordings_per_machine);
  recording.candidate = candidate_of(study, recording.machine);
  const MachineDraw machine = draw_machine(study, recording.machine);
  recording.part = machine.part;
  recording.clearance_m = machine.clearance_m;
  recording.stop_angle_deg = machine.stop_angle_deg;
  recording.mark_turns = machine.mark_turns;
  recording.gain = machine.gain;
  draw_motion(study, machine, recording, workspace);
  RandomStream random(study.seed, index, Purpose::of_readings);
  for (std::complex<double>& z : recording.motion.displacement_m)
    z *= std::polar(1.0, recording.stop_angle_deg * std::numbers::pi / 180);
  read_motion(study.measurement, random, recording);
  recording.motion.displacement_m.clear();
  return recording;
}

}  // namespace rubsweep::dataset
