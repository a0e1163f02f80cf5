#include <algorithm>
#include <array>
#include <atomic>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "rubdiagnose_arguments.hpp"
#include "rubsweep/maps/batch/parallel_run.hpp"
#include "rubsweep/maps/batch/progress.hpp"
#include "rubsweep/maps/batch/table_file.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/config/yaml/base.hpp"
#include "rubsweep/measurement/diagnose/answer/answer_text.hpp"
#include "rubsweep/measurement/diagnosis/diagnose_recording.hpp"
#include "rubsweep/measurement/recording/recording_file.hpp"
#include "shared/exit_code.hpp"
#include "shared/interrupt.hpp"
#include "shared/program.hpp"
#include "shared/result_directory.hpp"
#include "shared/run_summary.hpp"
#include "shared/shown_lengths.hpp"
#include "shared/working_time.hpp"

namespace rubsweep::apps {
namespace {

constexpr std::array<std::string_view, 4> file_names{"diagnosis.json", "probabilities.csv", "orbits.csv",
                                                     "lines.csv"};

struct Input {
  diagnosis::RecordedProblem recorded;
  std::string digest;  ///< digest of everything read
};

Input read_input(const RubdiagnoseArguments& arguments) {
  diagnosis::DiagnosisQuestions questions{
      .name = arguments.recording.string(), .machine = arguments.machine, .seed = arguments.seed};
  diagnosis::DiagnosedMachine machine = diagnosis::read_diagnosed_machine(arguments.machine, arguments.seed);
  std::string list;
  if (arguments.candidates) {
    questions.list = arguments.candidates->string();
    list = config::yaml::read_config_bytes(*arguments.candidates);
    questions.candidates = config::dataset::read_candidate_file_text(list, questions.list);
  }
  recording::ReadRecording read = recording::read_recording(arguments.recording, arguments.instrument);
  diagnosis::RecordedProblem recorded =
      diagnosis::recorded_problem(std::move(machine), std::move(read.recording), read.instrument, questions);
  std::string digest = config::digest_of(recorded.text + list + read.text);
  return {std::move(recorded), std::move(digest)};
}

/// Motions drawn from the priors: kept ones, or newly simulated ones with a progress display.
diagnose::inference::CaseSet motions_of(const RubdiagnoseArguments& arguments,
                                        const diagnosis::RecordedProblem& recorded,
                                        diagnosis::DiagnosisEffort effort) {
  if (auto kept = diagnosis::kept_motions(recorded, effort)) return *std::move(kept);
  const std::size_t all = recorded.problem.candidates.size() * static_cast<std::size_t>(effort.motions);
  batch::Progress progress(all, arguments.quiet ? batch::ProgressMode::never : arguments.progress);
  std::mutex one_at_a_time;
  std::size_t shown = 0;
  const Watch watch(
      [&] {
        const std::lock_guard lock(one_at_a_time);
        progress.refresh();
      },
      [] {});
  effort.on_motions = [&](std::size_t done, std::size_t) {
    const std::lock_guard lock(one_at_a_time);
    if (done > shown) progress.advance(done - shown);
    shown = std::max(shown, done);
  };
  return diagnosis::simulated_motions(recorded, effort);
}

/// Answer of the diagnosis; empty where it was interrupted before there were enough motions.
std::optional<diagnose::answer::Answer> answer_of(const RubdiagnoseArguments& arguments,
                                                  const diagnosis::RecordedProblem& recorded,
                                                  const std::atomic<bool>& stop) {
  const diagnosis::DiagnosisEffort effort{.motions = arguments.motions,
                                          .rounds = arguments.rounds,
                                          .threads = arguments.threads,
                                          .stop = &stop,
                                          .kept_motions = arguments.table};
  diagnose::inference::CaseSet motions = motions_of(arguments, recorded, effort);
  const WorkingTime working("rubdiagnose", "compares motions with the recording",
                            !arguments.quiet && arguments.progress != batch::ProgressMode::never);
  return diagnosis::answer_of(recorded, arguments.recording.filename().string(), std::move(motions), effort);
}

int look(const RubdiagnoseArguments& arguments) {
  const Input input = read_input(arguments);
  batch::require_threads(arguments.threads, 1);
  const ResultDirectory made(arguments.directory, file_names);
  const std::atomic<bool>& stop = catch_interrupts();
  const std::optional<diagnose::answer::Answer> found = answer_of(arguments, input.recorded, stop);
  if (!found) {
    say("rubdiagnose: interrupted; too few motions were simulated for an answer\n");
    return 128 + caught_signal();
  }
  const diagnose::answer::Answer& answer = *found;
  const diagnose::MotionLines lines =
      diagnosis::lines_of(input.recorded.recording, input.recorded.stretches.front());
  count_in_summary("motions", answer.cases);
  const batch::ResultFiles files{
      {"diagnosis.json", diagnose::answer::answer_json(answer)},
      {"probabilities.csv", diagnose::answer::probabilities_csv(answer)},
      {"orbits.csv", diagnose::answer::orbits_csv(answer, lines, input.recorded.recording.plane)},
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
