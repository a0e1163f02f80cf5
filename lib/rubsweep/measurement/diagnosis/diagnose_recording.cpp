#include "rubsweep/measurement/diagnosis/diagnose_recording.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <numbers>
#include <span>
#include <utility>

#include "rubsweep/core/error.hpp"
#include "rubsweep/measurement/diagnose/inference/kept_cases.hpp"

namespace rubsweep::diagnosis {
namespace {

namespace inference = diagnose::inference;

constexpr std::size_t fewest_motions = 100;  ///< Fewest motions from which a diagnosis answers.

/// Sets the known intervals of the machine in all candidates.
void tell_machine(const DiagnosedMachine& machine, const std::string& list,
                  std::vector<diagnose::Candidate>& candidates) {
  const diagnose::KnownKit* kit = machine.fixed.kit.get();
  for (diagnose::Candidate& candidate : candidates) {
    spread_of(candidate, diagnose::Unknown::natural_frequency) = machine.natural_frequency_hz;
    spread_of(candidate, diagnose::Unknown::damping_ratio) = machine.damping_ratio;
    const std::optional<diagnose::Spread>& position = candidate.position_m;
    if (position && (!kit || position->high > kit->length_m))
      throw ConfigError(fmt::format("{}: candidates: position_m of {}: {}, allowed: {}", list, candidate.name,
                                    kit ? "is beyond the shaft" : "is said of a Jeffcott rotor",
                                    kit ? fmt::format("0 to {}", kit->length_m) : "none"));
    if (!kit) continue;
    spread_of(candidate, diagnose::Unknown::kit) = {0, 1};
    spread_of(candidate, diagnose::Unknown::position) =
        position.value_or(diagnose::Spread{kit->from_m, kit->to_m});
    if (!kit->same_all_around && candidate.cause != diagnose::Cause::no_rub)
      spread_of(candidate, diagnose::Unknown::stop_angle) = {-180, 180};
  }
}

inference::CaseOptions case_options(const DiagnosisEffort& effort) {
  return {.cases_per_candidate = effort.motions + effort.rounds * motions_per_round,
          .threads = effort.threads,
          .stop = effort.stop,
          .on_cases = effort.on_motions};
}

/// Sets the speeds of further stretches, and says which stretches are compared.
void tell_further_speeds(RecordedProblem& recorded) {
  const std::span further = std::span(recorded.stretches).subspan(1);
  if (further.empty()) return;
  std::vector<std::string> speeds;
  for (const Stretch& stretch : further) {
    recorded.problem.further_speeds_hz.push_back(inference::simulated_speed_hz(stretch.speed_hz));
    speeds.push_back(fmt::format("{:.4g} Hz", stretch.speed_hz));
  }
  recorded.remarks.push_back(
      fmt::format("the speed changes: stretches of {} turns at {:.4g} Hz and at {} are compared",
                  recorded.problem.turns, recorded.stretches.front().speed_hz, fmt::join(speeds, " and ")));
}

/// Features of all compared stretches. `lines`: those of the first.
diagnose::features::DescribedMotion described(const RecordedProblem& recorded,
                                              const diagnose::MotionLines& lines) {
  response::spectrum::SpectrumWorkspace workspace;
  const diagnose::features::View view = inference::view_of(recorded.problem.measuring);
  diagnose::features::DescribedMotion seen = diagnose::features::describe(lines, view, workspace);
  for (std::size_t k = 1; k < recorded.stretches.size(); ++k)
    inference::add_further(
        recorded.problem, k - 1,
        diagnose::features::describe(lines_of(recorded.recording, recorded.stretches[k]), view, workspace),
        seen);
  return seen;
}

bool is_stopped(const DiagnosisEffort& effort) { return effort.stop && *effort.stop; }

}  // namespace

RecordedProblem recorded_problem(DiagnosedMachine machine, recording::Recording recording,
                                 const recording::Instrument& instrument,
                                 const DiagnosisQuestions& questions) {
  if (recording.place == recording::Place::casing)
    throw ConfigError(questions.name + ": is a recording of a casing, allowed: one of the shaft");
  std::vector<Stretch> stretches = compared_stretches(recording, questions.name);
  const double recorded_hz = stretches.front().speed_hz;
  const int turns = stretches.front().turns;
  const double speed_hz = inference::simulated_speed_hz(recorded_hz);
  prepare_kits(questions.machine, speed_hz, machine);
  const config::dataset::CandidateFile& candidates = questions.candidates;
  RecordedProblem recorded{.recording = std::move(recording),
                           .stretches = std::move(stretches),
                           .problem = {.candidates = candidates.candidates,
                                       .prior = candidates.prior,
                                       .fixed = machine.fixed,
                                       .eccentricity_m = candidates.eccentricity_m ? candidates.eccentricity_m
                                                                                   : machine.eccentricity_m,
                                       .speed_hz = speed_hz,
                                       .turns = turns,
                                       .measuring = candidates.measuring,
                                       .seed = questions.seed},
                           .remarks = machine.remarks,
                           .text = machine.text};
  inference::DiagnosisProblem& problem = recorded.problem;
  tell_further_speeds(recorded);
  problem.measuring.probes = recorded.recording.plane ? 2 : 1;
  problem.measuring.readings_per_turn = recorded.recording.sampling_rate_hz / recorded_hz;
  problem.measuring.directions = machine.fixed.kit && !machine.fixed.kit->same_all_around;
  problem.measuring.probe_angle_rad = instrument.probes.front().angle_deg * std::numbers::pi / 180;
  problem.measuring.from_rest = recorded.recording.from_rest;
  tell_machine(machine, questions.list, problem.candidates);
  const diagnose::Spread& natural_hz = machine.natural_frequency_hz;
  problem.measuring.natural_order = (natural_hz.low + natural_hz.high) / 2 / recorded_hz;
  return recorded;
}

std::optional<inference::CaseSet> kept_motions(const RecordedProblem& recorded,
                                               const DiagnosisEffort& effort) {
  if (effort.kept_motions.empty()) return std::nullopt;
  return inference::kept_cases(
      effort.kept_motions, inference::cases_digest(recorded.problem, case_options(effort)), recorded.problem);
}

inference::CaseSet simulated_motions(const RecordedProblem& recorded, const DiagnosisEffort& effort) {
  const inference::CaseOptions options = case_options(effort);
  inference::CaseSet set = prior_cases(recorded.problem, options);
  if (!effort.kept_motions.empty() && !is_stopped(effort))
    keep_cases(effort.kept_motions, inference::cases_digest(recorded.problem, options), set);
  return set;
}

std::optional<diagnose::answer::Answer> answer_of(const RecordedProblem& recorded, const std::string& name,
                                                  inference::CaseSet motions, const DiagnosisEffort& effort) {
  if (is_stopped(effort) && motions.cases.size() < fewest_motions) return std::nullopt;
  const inference::DiagnosisProblem& problem = recorded.problem;
  const double speed_hz = recorded.stretches.front().speed_hz;
  const diagnose::MotionLines lines = lines_of(recorded.recording, recorded.stretches.front());
  const diagnose::features::DescribedMotion seen = described(recorded, lines);
  const inference::Diagnosis diagnosis =
      inference::diagnose(problem, seen, {.cases = case_options(effort)}, std::move(motions));
  auto next = is_stopped(effort) ? std::vector<inference::NextMeasurement>{}
                                 : inference::next_measurements(problem, diagnosis, effort.threads);
  diagnose::answer::RecordingFacts facts{.name = name,
                                         .speed_hz = speed_hz,
                                         .turns = problem.turns,
                                         .probes = problem.measuring.probes,
                                         .size_m = seen.size_m,
                                         .findings = recorded.recording.findings};
  facts.findings.insert(facts.findings.end(), recorded.remarks.begin(), recorded.remarks.end());
  auto answer =
      diagnose::answer::answer_of(problem, diagnosis, seen, lines, std::move(facts), std::move(next));
  answer.interrupted = is_stopped(effort);
  const auto& probes = recorded.recording.probes;
  answer.signs = diagnose::answer::foreign_signs(
      lines, {.speed_hz = speed_hz,
              .natural_frequency_hz = problem.measuring.natural_order * speed_hz,
              .one_mode = problem.fixed.kit == nullptr,
              .probe_angle_deg = probes.size() == 2 ? std::optional(std::pair(probes.front().angle_deg,
                                                                              probes.back().angle_deg))
                                                    : std::nullopt});
  return answer;
}

std::optional<diagnose::answer::Answer> diagnose_recording(recording::Recording recording,
                                                           const recording::Instrument& instrument,
                                                           const DiagnosisQuestions& questions,
                                                           const DiagnosisEffort& effort) {
  const RecordedProblem recorded = recorded_problem(read_diagnosed_machine(questions.machine, questions.seed),
                                                    std::move(recording), instrument, questions);
  std::optional<inference::CaseSet> motions = kept_motions(recorded, effort);
  if (!motions) motions = simulated_motions(recorded, effort);
  return answer_of(recorded, questions.name, *std::move(motions), effort);
}

}  // namespace rubsweep::diagnosis
