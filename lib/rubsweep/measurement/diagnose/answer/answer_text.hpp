#pragma once

#include <string>

#include "rubsweep/core/model/length_text.hpp"
#include "rubsweep/measurement/diagnose/answer/answer.hpp"

namespace rubsweep::diagnose::answer {

/// One page for a reader; how sure it is stands in its first line.
std::string answer_text(const Answer& answer, const model::ShownLengths& shown = {});

/// Words for a cause: "one flat stop".
std::string_view words_for(Cause cause);

}  // namespace rubsweep::diagnose::answer
