#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rubsweep/measurement/diagnose/answer/foreign_cause.hpp"
#include "rubsweep/measurement/diagnose/inference/next_measurement.hpp"
#include "rubsweep/measurement/diagnose/observed_lines.hpp"

namespace rubsweep::diagnose::answer {

/// A simulated motion fitted onto a recorded one.
struct Overlay {
  MotionLines simulated{};  ///< scaled, rotated, phases counted from the recording's mark, m
  double unexplained = 0;   ///< share of the recorded energy, 0 to 1, that the simulated motion lacks
};

/// Fits a simulated motion onto the recorded one: scales it to the same size, shifts its start by the shaft
/// angle of best agreement and, with two probes, rotates it to the best agreement. The best of 64 starting
/// angles per turn has the largest correlation. Both motions are taken about their means and have equally
/// many turns.
Overlay lay_over(const MotionLines& recorded, const MotionLines& simulated, bool plane);

/// Median and 95 % interval of a machine parameter in its posterior distribution.
struct NumberInterval {
  std::string name;  ///< name with its unit
  double median = 0, low_95 = 0, high_95 = 0;
};

struct CandidateAnswer {
  std::string name;
  Cause cause = Cause::no_rub;
  double probability = 0;  ///< probability, with "none of these" among the alternatives
  std::vector<NumberInterval>
      numbers{};  ///< if this is the cause; empty for no_rub, or if no case is similar
  std::optional<double> standard_error{};  ///< empty where a probe is clipped
};

/// A feature of the recording, with its weighted mean and spread in the cases of both likeliest candidates.
struct DecidingFeature {
  std::string name;
  double recorded = 0, first = 0, first_spread = 0, second = 0, second_spread = 0;
  double nearer = 0;  ///< (distance to `second`)^2 - (distance to `first`)^2, in spreads
};

/// A simulated motion that explains the recording well.
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

/// All results of a diagnosis that the reader sees.
struct Answer {
  RecordingFacts recording{};
  std::vector<CandidateAnswer> candidates{};  ///< sorted by probability, the likeliest first
  double none = 0, p_value = 1;
  std::optional<double> none_standard_error{};
  bool size_fits = true;  ///< whether at least one simulated motion can have the size of the recording
  bool clipped = false;   ///< a probe saturates; no rotor motion explains that, so `none` is 1
  bool interrupted = false;
  std::size_t cases = 0;
  std::vector<DecidingFeature> deciding{};
  std::vector<BestMotion> best{};
  std::vector<ForeignSign> signs{};  ///< causes other than a rub that have such lines
  std::vector<inference::NextMeasurement> next{};
};

/// Builds the answer for the user. `recorded`: the lines of the recording.
Answer answer_of(const inference::DiagnosisProblem& problem, const inference::Diagnosis& diagnosis,
                 const features::DescribedMotion& seen, const MotionLines& recorded, RecordingFacts facts,
                 std::vector<inference::NextMeasurement> next);

}  // namespace rubsweep::diagnose::answer
