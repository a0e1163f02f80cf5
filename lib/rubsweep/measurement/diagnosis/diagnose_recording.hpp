#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "rubsweep/measurement/dataset/read_candidates.hpp"
#include "rubsweep/measurement/diagnose/answer/answer.hpp"
#include "rubsweep/measurement/diagnose/inference/diagnosis.hpp"
#include "rubsweep/measurement/diagnose/observed_lines.hpp"
#include "rubsweep/measurement/diagnosis/diagnosed_machine.hpp"
#include "rubsweep/measurement/recording/instrument.hpp"
#include "rubsweep/measurement/recording/recording.hpp"

namespace rubsweep::diagnosis {

/// Turns that are compared: as many as fractions of the speed up to 1/6 have whole periods in.
inline constexpr int most_turns = 30, fewest_turns = 12;

/// A recording, and the motions that it is compared with.
struct RecordedProblem {
  recording::Recording recording{};
  diagnose::inference::DiagnosisProblem problem{};
  std::vector<std::string> remarks{};  ///< sources of intervals that are not the file's
  std::string text{};                  ///< files of the machine, as they were read
};

/// Questions of a diagnosis.
struct DiagnosisQuestions {
  std::string name{};               ///< name of the recording, in messages and in the answer
  std::filesystem::path machine{};  ///< configuration of the machine, perhaps beside the files of a fit
  config::dataset::CandidateFile candidates = config::dataset::usual_candidate_file();
  std::string list{};  ///< name of the file of candidates, in messages
  std::uint64_t seed = 1;
};

/// Puts recording and machine together, which is that of `questions.machine`; stops of a kit may stand
/// anywhere between its supports, and at any angle where it is not the same all around. Throws ConfigError
/// for fewer turns than `fewest_turns`, for a speed that changes, and for places that the machine does not
/// have.
RecordedProblem recorded_problem(DiagnosedMachine machine, recording::Recording recording,
                                 const recording::Instrument& instrument,
                                 const DiagnosisQuestions& questions);

/// Effort of a diagnosis.
struct DiagnosisEffort {
  int motions = 600;                     ///< motions of each candidate, from the priors
  int rounds = 3;                        ///< most rounds of draws near motions that resemble the recording
  int threads = 0;                       ///< 0: all; decides no result
  const std::atomic<bool>* stop{};       ///< true: no new draw begins
  std::filesystem::path kept_motions{};  ///< directory where motions are kept from call to call; empty: none
  std::function<void(std::size_t done, std::size_t all)> on_motions{};  ///< one call at a time
};

/// Motions of the priors that an earlier call kept; empty where there are none.
std::optional<diagnose::inference::CaseSet> kept_motions(const RecordedProblem& recorded,
                                                         const DiagnosisEffort& effort);

/// Simulates motions of the priors, and keeps them unless it was stopped. Throws IoError.
diagnose::inference::CaseSet simulated_motions(const RecordedProblem& recorded,
                                               const DiagnosisEffort& effort);

/// Lines of the last turns of the recording, which are compared.
diagnose::MotionLines lines_of(const RecordedProblem& recorded);

/// Compares them with the recording. Empty where it was stopped before there were motions enough for an
/// answer.
std::optional<diagnose::answer::Answer> answer_of(const RecordedProblem& recorded, const std::string& name,
                                                  diagnose::inference::CaseSet motions,
                                                  const DiagnosisEffort& effort);

/// The same in one call: which stop a recording tells of, with probabilities and numbers of the machine.
/// Throws as read_diagnosed_machine and recorded_problem, and IoError.
std::optional<diagnose::answer::Answer> diagnose_recording(recording::Recording recording,
                                                           const recording::Instrument& instrument,
                                                           const DiagnosisQuestions& questions,
                                                           const DiagnosisEffort& effort = {});

}  // namespace rubsweep::diagnosis
