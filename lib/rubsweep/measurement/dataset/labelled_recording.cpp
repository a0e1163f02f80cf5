#include "rubsweep/measurement/dataset/labelled_recording.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <utility>

#include "rubsweep/core/error.hpp"
#include "rubsweep/measurement/diagnose/other_cause.hpp"
#include "rubsweep/measurement/recording/shaft_turns.hpp"

namespace rubsweep::dataset {
namespace {

using diagnose::Point;
using diagnose::RandomStream;
using diagnose::samples_per_revolution;
using diagnose::Unknown;

constexpr bool of_one_recording(Unknown unknown) {
  return unknown == Unknown::whirl_ratio || unknown == Unknown::kick_ratio ||
         unknown == Unknown::kick_angle || unknown == Unknown::kick_phase;
}

/// Computes the penetration and force ratios of the recording's rub.
void measure_rub(const DataStudy& study, LabelledRecording& recording) {
  constexpr double gravity_m_per_s2 = 9.80665;
  const double force_n = recording.motion.contact.peak_contact_force_n;
  recording.penetration_ratio = penetration_ratio(study.candidates[recording.candidate].cause,
                                                  recording.values, recording.clearance_m, force_n);
  recording.force_ratio = force_n / (study.fixed.rotor_mass_kg * gravity_m_per_s2);
}

/// Largest second difference of a motion over time.
double peak_acceleration(const std::vector<std::complex<double>>& motion, double speed_hz) {
  const double step_s = 1 / (speed_hz * samples_per_revolution);
  double peak = 0;
  for (std::size_t k = 1; k + 1 < motion.size(); ++k)
    peak = std::max(peak, std::abs(motion[k - 1] - 2.0 * motion[k] + motion[k + 1]) / (step_s * step_s));
  return peak;
}

/// Draws the numbers of this recording until its motion can be simulated and its rub stays within the study's
/// limits.
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
      // Each of these numbers is allowed, but the machine that they make together is not.
    }
  }
  throw SolverError(
      "recording " + std::to_string(recording.index) +
      ": no draw could be simulated that stays within rub.penetration_ratio and rub.force_ratio");
}

/// Puts the vibration of another cause in the place of a quiet whirl, with its amplitude at 1X, in the share
/// of recordings that the study asks for.
void vibrate_from_another_cause(const DataStudy& study, LabelledRecording& recording) {
  RandomStream random(study.seed, recording.index, Purpose::of_other_cause);
  if (study.candidates[recording.candidate].cause != diagnose::Cause::no_rub ||
      random.uniform() >= study.other_causes_share)
    return;
  std::vector<std::complex<double>>& motion = recording.motion.displacement_m;
  const double radius_m = diagnose::size_of(motion);
  auto other = diagnose::another_cause(motion.size(), samples_per_revolution, random);
  std::ranges::transform(other.samples, motion.begin(), [&](const auto& z) { return radius_m * z; });
  recording.other_cause = std::move(other.parts);
}

/// Readings of one direction at instants that are given in turns of the shaft.
std::vector<double> read(const std::vector<std::complex<double>>& motion, bool y,
                         const std::vector<double>& turns) {
  std::vector<double> signal;
  signal.reserve(motion.size());
  for (const std::complex<double> z : motion) signal.push_back(y ? z.imag() : z.real());
  // Each reading is the first sample of its own interval, so one more instant must end the last interval.
  std::vector<double> ends = turns;
  ends.push_back(2 * turns.back() - turns[turns.size() - 2]);
  return recording::at_equal_angles(signal, 0, samples_per_revolution, ends, 1);
}

}  // namespace

std::size_t candidate_of(const DataStudy& study, std::size_t machine) {
  return machine % study.candidates.size();
}

MachineDraw draw_machine(const DataStudy& study, std::size_t machine) {
  diagnose::RandomStream random(study.seed, machine, Purpose::of_machine);
  MachineDraw drawn;
  for (const diagnose::UnknownRow& row : diagnose::unknown_rows())
    if (!row.of_kit && row.unknown != Unknown::exponent)
      drawn.unit[static_cast<std::size_t>(row.unknown)] = random.uniform();
  drawn.clearance_m = value_at(study.candidates[candidate_of(study, machine)].clearance_m, random.uniform());
  drawn.stop_angle_deg = 360 * random.uniform();
  drawn.mark_turns = random.uniform();
  const double place = random.uniform();
  drawn.part = place < study.split.training                            ? "training"
               : place < study.split.training + study.split.validation ? "validation"
                                                                       : "test";
  for (int probe = 0; probe < study.measurement.probes; ++probe)
    drawn.gain.push_back(1 + study.measurement.gain_error * random.normal());
  // The exponent is drawn last, so that sets of linear springs keep the numbers of versions without
  // exponents.
  drawn.unit[static_cast<std::size_t>(Unknown::exponent)] = random.uniform();
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
  vibrate_from_another_cause(study, recording);
  recording.peak_acceleration_m_per_s2 =
      peak_acceleration(recording.motion.displacement_m, recording.speed_hz);
  RandomStream random(study.seed, index, Purpose::of_readings);
  for (std::complex<double>& z : recording.motion.displacement_m)
    z *= std::polar(1.0, recording.stop_angle_deg * std::numbers::pi / 180);
  read_motion(study.measurement, random, recording);
  recording.motion.displacement_m.clear();
  return recording;
}

void read_motion(const Measurement& measurement, diagnose::RandomStream& random,
                 LabelledRecording& recording) {
  std::vector<std::complex<double>>& motion = recording.motion.displacement_m;
  const double size_m = diagnose::size_of(motion);
  add_other_lines(motion, measurement.other_lines, size_m, random);
  recording.noise_m = size_m * value_at(measurement.noise_share, random.uniform());
  const auto samples = static_cast<double>(motion.size() - 1);
  std::vector<double> turns;
  for (long k = 0;; ++k) {
    const double t_s = static_cast<double>(k) / measurement.sampling_rate_hz, turn = t_s * recording.speed_hz;
    if (turn * samples_per_revolution > samples) break;
    turns.push_back(turn);
    recording.t_s.push_back(t_s);
    const double since_mark = turn - recording.mark_turns - std::floor(turn - recording.mark_turns);
    recording.keyphasor_v.push_back(since_mark < mark_share ? mark_v : no_mark_v);
  }
  for (std::size_t probe = 0; probe < recording.gain.size(); ++probe) {
    std::vector<double>& column = probe == 0 ? recording.x_m : recording.y_m;
    column = read(motion, probe == 1, turns);
    for (double& value : column) value = recording.gain[probe] * value + recording.noise_m * random.normal();
  }
}

}  // namespace rubsweep::dataset
