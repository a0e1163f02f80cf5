// diagnosis_calibration FIRST COUNT SEED: recordings of machines that are drawn from the priors of rubdata,
// one candidate after the other, diagnosed as rubdiagnose does. A line of CSV for each: the truth, the
// probabilities, and where the true numbers lie in their posterior distributions. Machines, motions and
// readings are those of rubdata, whose code for them the diagnosis does not use.

#include <fmt/format.h>

#include <cstdlib>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "rubsweep/dataset/labelled_recording.hpp"
#include "rubsweep/diagnose/diagnosis.hpp"
#include "rubsweep/diagnose/quantity.hpp"
#include "rubsweep/recording/recording.hpp"

namespace {

using namespace rubsweep;
using diagnose::Quantity;
using diagnose::Unknown;

dataset::DataStudy study_of(std::uint64_t seed, std::size_t trial) {
  dataset::DataStudy study;
  study.seed = seed * 1'000'003 + trial;
  study.recordings_per_machine = 1;
  study.fixed = {.rotor_mass_kg = 0.8, .contact_radius_m = 0.0375, .casing_damping_ratio = 0.1};
  study.candidates = {diagnose::usual_candidate(diagnose::all_causes[trial % diagnose::all_causes.size()])};
  spread_of(study.candidates[0], Unknown::natural_frequency) = {20, 60, false};
  spread_of(study.candidates[0], Unknown::damping_ratio) = {0.01, 0.04, true};
  study.candidates[0].clearance_m = {5e-5, 1e-3, true};
  // Half of the recordings are read every millisecond, a third by one probe.
  const std::size_t round = trial / diagnose::all_causes.size();
  study.measurement.sampling_rate_hz = round % 2 == 0 ? 10'000 : 1000;
  study.measurement.probes = round % 3 == 2 ? 1 : 2;
  if (round % 2 == 1) study.speed_ratio.high = 3;
  return study;
}

/// Draws machines until one does what its candidate says.
dataset::LabelledRecording draw_recording(const dataset::DataStudy& study,
                                          response::motion::Workspace& workspace) {
  const bool rubs = study.candidates[0].cause != diagnose::Cause::no_rub;
  for (std::size_t index = 0;; ++index) {
    dataset::LabelledRecording recording = dataset::make_recording(study, index, workspace);
    // A shaft that turns faster than ten readings show is not asked about.
    if (recording.motion.rubs == rubs && study.measurement.sampling_rate_hz > 8 * recording.speed_hz)
      return recording;
  }
}

recording::Recording measured(const dataset::LabelledRecording& labelled) {
  recording::Channels channels;
  channels.channels.push_back({"t", "s", labelled.t_s});
  channels.channels.push_back({"x", "m", labelled.x_m});
  if (!labelled.y_m.empty()) channels.channels.push_back({"y", "m", labelled.y_m});
  channels.channels.push_back({"key", "V", labelled.keyphasor_v});
  recording::Instrument instrument;
  instrument.time = "t";
  instrument.probes.push_back({.column = "x"});
  if (!labelled.y_m.empty()) instrument.probes.push_back({.column = "y", .angle_deg = 90});
  instrument.keyphasor = recording::Keyphasor{.column = "key"};
  return recording::make_recording(channels, instrument, "simulated");
}

/// Intervals of the machine that a fit would leave: 1 % of the frequency, 20 % of the damping.
void tell_machine(const dataset::LabelledRecording& labelled, std::vector<diagnose::Candidate>& candidates,
                  std::mt19937_64& random) {
  const auto about = [&](double truth, double half_width) {
    const double middle = truth * (1 + half_width * std::uniform_real_distribution<double>(-1, 1)(random));
    return diagnose::Spread{middle / (1 + half_width), middle * (1 + half_width), false};
  };
  const diagnose::Spread frequency = about(value_of(labelled.values, Unknown::natural_frequency), 0.01),
                         damping = about(value_of(labelled.values, Unknown::damping_ratio), 0.2);
  for (diagnose::Candidate& candidate : candidates) {
    spread_of(candidate, Unknown::natural_frequency) = frequency;
    spread_of(candidate, Unknown::damping_ratio) = damping;
    candidate.clearance_m = {5e-5, 1e-3, true};
  }
}

double truth_of(const dataset::LabelledRecording& labelled, Quantity quantity) {
  switch (quantity) {
    case Quantity::clearance:
      return labelled.clearance_m;
    case Quantity::stop_angle:
      return labelled.stop_angle_deg;
    case Quantity::contact_fraction:
      return labelled.motion.contact.contact_fraction;
    case Quantity::peak_force:
      return labelled.motion.contact.peak_contact_force_n;
    case Quantity::eccentricity:
      return labelled.motion.eccentricity_m;
    case Quantity::whirl_ratio:
      return value_of(labelled.values, Unknown::whirl_ratio);
    case Quantity::stiffness:
      return value_of(labelled.values, Unknown::stiffness);
    case Quantity::restitution:
      return value_of(labelled.values, Unknown::restitution);
    case Quantity::friction:
      return value_of(labelled.values, Unknown::friction);
  }
  return 0;
}

void run(std::size_t trial, std::uint64_t seed, int cases) {
  response::motion::Workspace workspace;
  const dataset::DataStudy study = study_of(seed, trial);
  const dataset::LabelledRecording labelled = draw_recording(study, workspace);
  const recording::Recording recording = measured(labelled);
  diagnose::DiagnosisProblem problem;
  problem.candidates = diagnose::usual_candidates();
  problem.prior.assign(problem.candidates.size(), 1.0 / static_cast<double>(problem.candidates.size()));
  problem.fixed = study.fixed;
  problem.speed_hz = recording.mean_speed_hz();
  problem.turns = std::min(recording.turns(), 32);
  problem.measuring.probes = study.measurement.probes;
  problem.measuring.readings_per_turn = study.measurement.sampling_rate_hz / problem.speed_hz;
  std::mt19937_64 random(study.seed);
  tell_machine(labelled, problem.candidates, random);
  const auto count = static_cast<std::size_t>(problem.turns * recording::samples_per_revolution);
  const std::span all(recording.displacement_m);
  const diagnose::MotionLines lines =
      diagnose::lines_of(all.last(count), problem.turns, seen_order(problem.measuring), workspace.spectrum);
  const diagnose::DescribedMotion seen = describe(lines, recording.plane, workspace.spectrum);
  diagnose::DiagnosisOptions options;
  options.cases.cases_per_candidate = cases;
  options.cases.threads = 1;
  const diagnose::Diagnosis diagnosis = diagnose::diagnose(problem, seen, options);
  const std::size_t truth = trial % problem.candidates.size();
  std::string line = fmt::format("{},{},{},{},{}", trial, problem.candidates[truth].name,
                                 to_string(labelled.motion.motion_class), study.measurement.sampling_rate_hz,
                                 study.measurement.probes);
  for (const double p : diagnosis.posterior.probability) line += fmt::format(",{:.4f}", p);
  line +=
      fmt::format(",{:.4f},{:.4f},{},{:.3f},{}", diagnosis.posterior.none, diagnosis.posterior.p_value,
                  diagnosis.history.size() - 1, diagnosis.posterior.sharpness, diagnosis.set.cases.size());
  Eigen::VectorXd weight = diagnosis.posterior.weight;
  for (Eigen::Index i = 0; i < weight.size(); ++i)
    if (diagnosis.set.cases[static_cast<std::size_t>(i)].candidate != truth) weight(i) = 0;
  for (const Quantity quantity : diagnose::all_quantities)
    line += fmt::format(
        ",{:.4f}", share_below(values_in_cases(problem, diagnosis.set, diagnosis.observed, seen, quantity),
                               weight, truth_of(labelled, quantity), quantity == Quantity::stop_angle));
  fmt::print("{}\n", line);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) return 1;
  const auto first = std::strtoul(argv[1], nullptr, 10), count = std::strtoul(argv[2], nullptr, 10);
  for (std::size_t trial = first; trial < first + count; ++trial)
    run(trial, std::strtoul(argv[3], nullptr, 10), argc > 4 ? std::atoi(argv[4]) : 600);
}
