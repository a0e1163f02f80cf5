#pragma once

#include <string>

#include "rubsweep/diagnose/answer/answer.hpp"
#include "rubsweep/model/length_text.hpp"

namespace rubsweep::diagnose::answer {

/// One page for a reader; how sure it is stands in its first line.
std::string answer_text(const Answer& answer, const model::ShownLengths& shown = {});

/// Words for a cause: "one flat stop".
std::string_view words_for(Cause cause);

}  // namespace rubsweep::diagnose::answer
