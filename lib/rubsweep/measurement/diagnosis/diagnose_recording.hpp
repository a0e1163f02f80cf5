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
#include "rubsweep/measurement/diagnosis/compared_stretches.hpp"
#include "rubsweep/measurement/diagnosis/diagnosed_machine.hpp"
#include "rubsweep/measurement/recording/instrument.hpp"
#include "rubsweep/measurement/recording/recording.hpp"

namespace rubsweep::diagnosis {

/// A recording, and the problem that defines the motions it is compared with.
struct RecordedProblem {
  recording::Recording recording{};
  std::vector<Stretch> stretches{};  ///< compared_stretches of the recording
  diagnose::inference::DiagnosisProblem problem{};
  std::vector<std::string> remarks{};  ///< compared speeds; sources of intervals other than the file
  std::string text{};                  ///< text of the machine's files as they were when read
};

/// Input of a diagnosis in addition to the recording.
struct DiagnosisQuestions {
  std::string name{};               ///< name of the recording, in messages and in the answer
  std::filesystem::path machine{};  ///< machine's configuration, with the files of a fit beside it if any
  config::dataset::CandidateFile candidates = config::dataset::usual_candidate_file();
  std::string list{};  ///< name of the candidates' file, in messages
  std::uint64_t seed = 1;
};

/// Combines a recording with the machine of `questions.machine`. Stops of a kit may stand anywhere between
/// its supports and, on an anisotropic kit, at any angle. Throws ConfigError like compared_stretches, and for
/// positions that the machine does not have.
RecordedProblem recorded_problem(DiagnosedMachine machine, recording::Recording recording,
                                 const recording::Instrument& instrument,
                                 const DiagnosisQuestions& questions);

/// Motions per candidate instead of one round of an earlier version, which drew them near the likeliest ones.
inline constexpr int motions_per_round = 160;

/// Effort of a diagnosis.
struct DiagnosisEffort {
  int motions = 600;                     ///< motions drawn from the priors, per candidate
  int rounds = 0;                        ///< each means motions_per_round more motions per candidate
  int threads = 0;                       ///< 0: all processors; does not change the result
  const std::atomic<bool>* stop{};       ///< true: no new draw begins
  std::filesystem::path kept_motions{};  ///< directory that keeps motions between calls; empty: none
  std::function<void(std::size_t done, std::size_t all)> on_motions{};  ///< progress; one call at a time
};

/// Motions that an earlier call drew from the priors and kept; empty where there are none.
std::optional<diagnose::inference::CaseSet> kept_motions(const RecordedProblem& recorded,
                                                         const DiagnosisEffort& effort);

/// Simulates motions drawn from the priors, and keeps them unless the run was stopped. Throws IoError.
diagnose::inference::CaseSet simulated_motions(const RecordedProblem& recorded,
                                               const DiagnosisEffort& effort);

/// Compares the motions with the recording. Empty if it was stopped before there were enough motions.
std::optional<diagnose::answer::Answer> answer_of(const RecordedProblem& recorded, const std::string& name,
                                                  diagnose::inference::CaseSet motions,
                                                  const DiagnosisEffort& effort);

/// Complete diagnosis in one call: which stop the recording shows, with probabilities and parameters of the
/// machine. Throws like read_diagnosed_machine and recorded_problem, and IoError.
std::optional<diagnose::answer::Answer> diagnose_recording(recording::Recording recording,
                                                           const recording::Instrument& instrument,
                                                           const DiagnosisQuestions& questions,
                                                           const DiagnosisEffort& effort = {});

}  // namespace rubsweep::diagnosis
