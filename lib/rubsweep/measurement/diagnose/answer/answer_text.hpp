#pragma once

#include <string>

#include "rubsweep/core/model/length_text.hpp"
#include "rubsweep/measurement/diagnose/answer/answer.hpp"

namespace rubsweep::diagnose::answer {

/// candidate,probability: the likeliest first, none_of_these last.
std::string probabilities_csv(const Answer& answer);

/// turns, x_m, y_m, simulated_x_m, simulated_y_m: the recorded motion about its mean and the closest
/// simulated one over the last turns, 64 points each; of one probe no y. Empty where no motion was simulated.
std::string orbits_csv(const Answer& answer, const MotionLines& recorded, bool plane);

/// order, recorded_m, simulated_m: lines of both with amplitudes above a thousandth of the largest.
std::string compared_lines_csv(const Answer& answer, const MotionLines& recorded);

/// The answer as JSON, two spaces a level: docs/formats.md, "diagnosis.json".
std::string answer_json(const Answer& answer);

/// One page for a reader; how sure it is stands in its first line.
std::string answer_text(const Answer& answer, const model::ShownLengths& shown = {});

/// Words for a cause: "one flat stop".
std::string_view words_for(Cause cause);

}  // namespace rubsweep::diagnose::answer
