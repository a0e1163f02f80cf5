#include "rubsweep/dataset/labelled_recording.hpp"

#include <cmath>
#include <complex>
#include <exception>
#include <numbers>
#include <optional>
#include <span>

#include "rubsweep/dataset/readings.hpp"
#include "rubsweep/diagnose/random_stream.hpp"
#include "rubsweep/error.hpp"

namespace rubsweep::dataset {
namespace {

using diagnose::Point;
using diagnose::RandomStream;
using diagnose::Unknown;

/// Purposes of the random numbers.
enum Purpose : std::uint64_t { of_machine = 101, of_recording, of_readings };

constexpr bool of_one_recording(Unknown unknown) {
  return unknown == Unknown::whirl_ratio || unknown == Unknown::kick_ratio ||
         unknown == Unknown::kick_angle || unknown == Unknown::kick_phase;
}

/// Numbers of a machine that its recordings have in common.
struct Drawn {
  Point unit{};
  double clearance_m = 0, stop_angle_deg = 0, mark_turns = 0;
  std::string_view part;
  std::vector<double> gain{};
};

Drawn draw_machine(const DataStudy& study, std::size_t machine, std::size_t candidate) {
  RandomStream random(study.seed, machine, of_machine);
  Drawn drawn;
  for (double& place : drawn.unit) place = random.uniform();
  drawn.clearance_m = value_at(study.candidates[candidate].clearance_m, random.uniform());
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

/// A motion with the numbers that are drawn until it runs.
void draw_motion(const DataStudy& study, const Drawn& machine, LabelledRecording& recording,
                 response::motion::Workspace& workspace) {
  constexpr int most_draws = 100;
  const diagnose::Candidate& candidate = study.candidates[recording.candidate];
  RandomStream random(study.seed, recording.index, of_recording);
  for (; recording.draws <= most_draws; ++recording.draws) {
    Point unit = machine.unit;
    for (const diagnose::UnknownRow& row : diagnose::unknown_rows())
      if (of_one_recording(row.unknown)) unit[static_cast<std::size_t>(row.unknown)] = random.uniform();
    recording.values = values_at(candidate, unit);
    recording.speed_hz = value_at(study.speed_ratio, random.uniform()) *
                         value_of(recording.values, Unknown::natural_frequency);
    diagnose::SettlingOptions settling;
    settling.max_revolutions = 400;
    settling.window_revolutions = 64;
    settling.exponent = true;
    try {
      const auto motion = diagnose::simulate_motion(
          drawn_machine(candidate.cause, recording.values, recording.clearance_m, study.fixed),
          recording.speed_hz, scene::WhirlRatio{value_of(recording.values, Unknown::whirl_ratio)},
          study.measurement.turns, settling, workspace);
      if (!motion) continue;
      recording.motion = *motion;
      return;
    } catch (const ConfigError&) {
      // Numbers that are each allowed, but not together.
    }
  }
  throw SolverError("recording " + std::to_string(recording.index) + ": no draw could be simulated");
}

}  // namespace

LabelledRecording make_recording(const DataStudy& study, std::size_t index,
                                 response::motion::Workspace& workspace) {
  LabelledRecording recording;
  recording.index = index;
  recording.machine = index / static_cast<std::size_t>(study.recordings_per_machine);
  recording.candidate = recording.machine % study.candidates.size();
  const Drawn machine = draw_machine(study, recording.machine, recording.candidate);
  recording.part = machine.part;
  recording.clearance_m = machine.clearance_m;
  recording.stop_angle_deg = machine.stop_angle_deg;
  recording.gain = machine.gain;
  draw_motion(study, machine, recording, workspace);
  RandomStream random(study.seed, index, of_readings);
  for (std::complex<double>& z : recording.motion.displacement_m)
    z *= std::polar(1.0, recording.stop_angle_deg * std::numbers::pi / 180);
  read_motion(study.measurement, machine.mark_turns, random, recording);
  recording.motion.displacement_m.clear();
  return recording;
}

}  // namespace rubsweep::dataset
