#pragma once

#include <string>

#include "rubsweep/core/model/length_text.hpp"
#include "rubsweep/measurement/diagnose/answer/answer.hpp"

namespace rubsweep::diagnose::answer {

/// CSV with the columns candidate and probability: the likeliest first, none_of_these last.
std::string probabilities_csv(const Answer& answer);

/// CSV with turns, x_m, y_m, simulated_x_m, simulated_y_m: the recorded motion about its mean and the closest
/// simulated one over the last turns, 64 points per turn. With one probe the y columns are missing. Empty
/// where no motion was simulated.
std::string orbits_csv(const Answer& answer, const MotionLines& recorded, bool plane);

/// CSV with order, recorded_m, simulated_m: lines whose amplitude exceeds a thousandth of the largest in
/// either motion.
std::string compared_lines_csv(const Answer& answer, const MotionLines& recorded);

/// The answer as JSON, indented by two spaces per level: docs/formats.md, "diagnosis.json".
std::string answer_json(const Answer& answer);

/// Report of one page; its first line says how certain the answer is.
std::string answer_text(const Answer& answer, const model::ShownLengths& shown = {});

std::string_view words_for(Cause cause);  ///< Plain words for a cause, such as "one flat stop".

}  // namespace rubsweep::diagnose::answer
