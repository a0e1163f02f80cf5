#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <filesystem>
#include <mutex>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "diagnosed_machine.hpp"
#include "rubdiagnose_arguments.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/input_file.hpp"
#include "rubsweep/maps/batch/parallel_run.hpp"
#include "rubsweep/maps/batch/progress.hpp"
#include "rubsweep/maps/batch/result_files.hpp"
#include "rubsweep/maps/config/study_digest.hpp"
#include "rubsweep/maps/config/yaml/file_bytes.hpp"
#include "rubsweep/measurement/dataset/read_candidates.hpp"
#include "rubsweep/measurement/diagnose/answer/answer_text.hpp"
#include "rubsweep/measurement/diagnose/inference/kept_cases.hpp"
#include "rubsweep/measurement/recording/read_instrument.hpp"
#include "rubsweep/measurement/recording/recording.hpp"
#include "rubsweep/measurement/recording/recording_file.hpp"
#include "rubsweep/measurement/scope/order_history.hpp"
#include "shared/exit_code.hpp"
#include "shared/interrupt.hpp"
#include "shared/program.hpp"
#include "shared/result_directory.hpp"
#include "shared/run_summary.hpp"
#include "shared/shown_lengths.hpp"
#include "shared/working_time.hpp"

namespace rubsweep::apps {
namespace {

namespace inference = diagnose::inference;

constexpr std::array<std::string_view, 4> file_names{"diagnosis.json", "probabilities.csv", "orbits.csv",
                                                     "lines.csv"};

/// Turns that are compared: as many as fractions of the speed up to 1/6 have whole periods in.
constexpr int most_turns = 30, fewest_turns = 12;

struct Input {
  recording::Recording recording;
  inference::DiagnosisProblem problem;
  std::string digest;  ///< of everything read
  std::vector<std::string> remarks{};
};

struct ReadRecording {
  recording::Recording recording;
  std::string text;            ///< of its files
  double probe_angle_deg = 0;  ///< of the first one
};

ReadRecording read_recording(const RubdiagnoseArguments& arguments) {
  const std::string description = config::yaml::read_config_bytes(arguments.instrument);
  const recording::Instrument instrument =
      config::recording::read_instrument_text(description, arguments.instrument.string());
  const std::string bytes = batch::read_input(arguments.recording);
  const std::string name = arguments.recording.string();
  recording::Recording recording =
      recording::make_recording(recording::read_recording_file(arguments.recording, bytes), instrument, name);
  if (recording.turns() < fewest_turns)
    throw ConfigError(
        fmt::format("{}: has {} whole turns, allowed: {} or more", name, recording.turns(), fewest_turns));
  if (scope::speed_changes(recording))
    throw ConfigError(name + ": the speed changes, allowed: a steady one, or from_s and to_s");
  return {std::move(recording), description + bytes, instrument.probes.front().angle_deg};
}

/// Knowledge of the machine in the candidates. Stops of a kit may stand anywhere between its supports, and at
/// any angle where it is not the same all around.
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

Input read_input(const RubdiagnoseArguments& arguments) {
  DiagnosedMachine machine = read_diagnosed_machine(arguments.machine, arguments.seed);
  const std::string list =
      arguments.candidates ? config::yaml::read_config_bytes(*arguments.candidates) : std::string();
  const config::dataset::CandidateFile candidates =
      arguments.candidates ? config::dataset::read_candidate_file_text(list, arguments.candidates->string())
                           : config::dataset::usual_candidate_file();
  ReadRecording read = read_recording(arguments);
  const double speed_hz = inference::simulated_speed_hz(read.recording.mean_speed_hz());
  prepare_kits(arguments.machine, speed_hz, machine);
  Input input{
      .recording = std::move(read.recording), .problem = {}, .digest = {}, .remarks = machine.remarks};
  inference::DiagnosisProblem& problem = input.problem;
  problem = {.candidates = candidates.candidates,
             .prior = candidates.prior,
             .fixed = machine.fixed,
             .eccentricity_m = candidates.eccentricity_m ? candidates.eccentricity_m : machine.eccentricity_m,
             .speed_hz = speed_hz,
             .turns = std::min(input.recording.turns(), most_turns),
             .measuring = candidates.measuring,
             .seed = arguments.seed};
  problem.measuring.probes = input.recording.plane ? 2 : 1;
  problem.measuring.readings_per_turn = input.recording.sampling_rate_hz / input.recording.mean_speed_hz();
  problem.measuring.directions = machine.fixed.kit && !machine.fixed.kit->same_all_around;
  problem.measuring.probe_angle_rad = read.probe_angle_deg * std::numbers::pi / 180;
  problem.measuring.from_rest = input.recording.from_rest;
  tell_machine(machine, arguments.candidates ? arguments.candidates->string() : "", problem.candidates);
  input.digest = config::digest_of(machine.text + list + read.text);
  return input;
}

/// Cases of the priors: kept ones, or new ones, which are kept.
inference::CaseSet cases_of(const RubdiagnoseArguments& arguments, const inference::DiagnosisProblem& problem,
                            inference::CaseOptions options) {
  const std::string digest = inference::cases_digest(problem, options);
  if (auto kept = inference::kept_cases(arguments.table, digest, problem)) return *std::move(kept);
  const std::size_t all = problem.candidates.size() * static_cast<std::size_t>(options.cases_per_candidate);
  batch::Progress progress(all, arguments.quiet ? batch::ProgressMode::never : arguments.progress);
  std::mutex one_at_a_time;
  std::size_t shown = 0;
  const Watch watch(
      [&] {
        const std::lock_guard lock(one_at_a_time);
        progress.refresh();
      },
      [] {});
  options.on_cases = [&](std::size_t done, std::size_t) {
    const std::lock_guard lock(one_at_a_time);
    if (done > shown) progress.advance(done - shown);
    shown = std::max(shown, done);
  };
  inference::CaseSet set = prior_cases(problem, options);
  if (!*options.stop) keep_cases(arguments.table, digest, set);
  return set;
}

/// Empty where it was interrupted before there were motions enough for an answer.
std::optional<diagnose::answer::Answer> answer_of(const RubdiagnoseArguments& arguments, const Input& input,
                                                  const diagnose::MotionLines& lines,
                                                  const std::atomic<bool>& stop) {
  response::spectrum::SpectrumWorkspace workspace;
  const diagnose::features::DescribedMotion seen =
      diagnose::features::describe(lines, inference::view_of(input.problem.measuring), workspace);
  inference::DiagnosisOptions options{.most_rounds = arguments.rounds};
  options.cases.cases_per_candidate = arguments.motions;
  options.cases.threads = arguments.threads;
  options.cases.stop = &stop;
  inference::CaseSet set = cases_of(arguments, input.problem, options.cases);
  constexpr std::size_t fewest = 100;
  if (stop && set.cases.size() < fewest) return std::nullopt;
  const WorkingTime working("rubdiagnose", "compares motions with the recording",
                            !arguments.quiet && arguments.progress != batch::ProgressMode::never);
  const inference::Diagnosis diagnosis = inference::diagnose(input.problem, seen, options, std::move(set));
  auto next = stop ? std::vector<inference::NextMeasurement>{}
                   : inference::next_measurements(input.problem, diagnosis, arguments.threads);
  diagnose::answer::RecordingFacts facts{.name = arguments.recording.filename().string(),
                                         .speed_hz = input.recording.mean_speed_hz(),
                                         .turns = input.problem.turns,
                                         .probes = input.problem.measuring.probes,
                                         .size_m = seen.size_m,
                                         .findings = input.recording.findings};
  facts.findings.insert(facts.findings.end(), input.remarks.begin(), input.remarks.end());
  auto answer =
      diagnose::answer::answer_of(input.problem, diagnosis, seen, lines, std::move(facts), std::move(next));
  answer.interrupted = stop;
  return answer;
}

diagnose::MotionLines lines_of(const Input& input) {
  response::spectrum::SpectrumWorkspace workspace;
  const std::span all(input.recording.displacement_m);
  return diagnose::lines_of(
      all.last(static_cast<std::size_t>(input.problem.turns) * recording::samples_per_revolution),
      input.problem.turns, inference::seen_order(input.problem.measuring), workspace);
}

int look(const RubdiagnoseArguments& arguments) {
  const Input input = read_input(arguments);
  batch::require_threads(arguments.threads, 1);
  const ResultDirectory made(arguments.directory, file_names);
  const std::atomic<bool>& stop = catch_interrupts();
  const diagnose::MotionLines lines = lines_of(input);
  const std::optional<diagnose::answer::Answer> found = answer_of(arguments, input, lines, stop);
  if (!found) {
    say("rubdiagnose: interrupted; too few motions were simulated for an answer\n");
    return 128 + caught_signal();
  }
  const diagnose::answer::Answer& answer = *found;
  count_in_summary("motions", answer.cases);
  const batch::ResultFiles files{
      {"diagnosis.json", diagnose::answer::answer_json(answer)},
      {"probabilities.csv", diagnose::answer::probabilities_csv(answer)},
      {"orbits.csv", diagnose::answer::orbits_csv(answer, lines, input.recording.plane)},
      {"lines.csv", diagnose::answer::compared_lines_csv(answer, lines)}};
  batch::write_result_files(files, file_names, arguments.directory, {"rubdiagnose", input.digest, {}});
  if (!arguments.quiet)
    print("{}{}", diagnose::answer::answer_text(answer, arguments.shown),
          batch::files_line(files, arguments.directory));
  draw_and_say(arguments.figure, "diagnosis", arguments.directory, arguments.recording.filename().string(),
               arguments.quiet, drawn_lengths(arguments.shown, true, false));
  if (stop) {
    say("rubdiagnose: interrupted; the answer so far is written\n");
    return 128 + caught_signal();
  }
  return done;
}

int perform(const RubdiagnoseArguments& arguments) {
  if (answered("rubdiagnose", arguments.action, rubdiagnose_help)) return done;
  return look(arguments);
}

}  // namespace
}  // namespace rubsweep::apps

int main(int argc, char** argv) {
  using namespace rubsweep::apps;
  return run_program("rubdiagnose", [&] { return perform(parse_rubdiagnose_arguments(argc, argv)); });
}
