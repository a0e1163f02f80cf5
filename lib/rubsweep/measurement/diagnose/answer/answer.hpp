#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rubsweep/measurement/diagnose/inference/next_measurement.hpp"
#include "rubsweep/measurement/diagnose/observed_lines.hpp"

namespace rubsweep::diagnose::answer {

/// A simulated motion laid over a recorded one.
struct Overlay {
  MotionLines simulated{};  ///< scaled, turned and recorded from the same mark, m
  double unexplained = 0;   ///< share of the recorded energy that it leaves, from 0 to 1
};

/// Scales a simulated motion to the size of the recorded one, begins it at the angle of the shaft where both
/// agree best and, of two probes, turns it to where they agree best: largest correlation over 64 begins a
/// turn. Both about their means, of the same number of turns.
Overlay lay_over(const MotionLines& recorded, const MotionLines& simulated, bool plane);

/// A number of the machine in words of its posterior distribution.
struct NumberInterval {
  std::string name;  ///< with its unit
  double median = 0, low_95 = 0, high_95 = 0;
};

struct CandidateAnswer {
  std::string name;
  Cause cause = Cause::no_rub;
  double probability = 0;  ///< "none of these" counted in
  std::vector<NumberInterval>
      numbers{};  ///< given that it is this one; none of no_rub, or where no case is like it
  std::optional<double> standard_error{};  ///< given where more motions would still change the probability
};

/// A feature of the recording beside those of the cases of the two likeliest candidates, weighted.
struct DecidingFeature {
  std::string name;
  double recorded = 0, first = 0, first_spread = 0, second = 0, second_spread = 0;
  double nearer = 0;  ///< square of the distance to the second in spreads less that to the first
};

/// A simulated motion that explains the recording.
struct BestMotion {
  std::string candidate;
  Overlay overlay{};
};

/// Facts of the recording that an answer repeats.
struct RecordingFacts {
  std::string name;
  double speed_hz = 0;
  int turns = 0, probes = 2;
  double size_m = 0;
  std::vector<std::string> findings{};
};

/// Everything that a reader is told.
struct Answer {
  RecordingFacts recording{};
  std::vector<CandidateAnswer> candidates{};  ///< the likeliest first
  double none = 0, p_value = 1;
  std::optional<double> none_standard_error{};
  bool size_fits = true;  ///< some simulated motion may be as large as the recording
  bool clipped = false;   ///< a probe that clips shows what no rotor does: none is 1
  bool stands_still = false, interrupted = false;
  int rounds = 0;
  std::size_t cases = 0;
  std::vector<DecidingFeature> deciding{};
  std::vector<BestMotion> best{};
  std::vector<inference::NextMeasurement> next{};
};

/// Puts an answer together. `recorded`: the lines of the recording.
Answer answer_of(const inference::DiagnosisProblem& problem, const inference::Diagnosis& diagnosis,
                 const features::DescribedMotion& seen, const MotionLines& recorded, RecordingFacts facts,
                 std::vector<inference::NextMeasurement> next);

}  // namespace rubsweep::diagnose::answer
