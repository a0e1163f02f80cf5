#pragma once

#include <string>

#include "rubsweep/measurement/diagnose/answer/answer.hpp"

namespace rubsweep::diagnose::answer {

/// The answer as JSON, two spaces a level: docs/formats.md, "diagnosis.json".
std::string answer_json(const Answer& answer);

}  // namespace rubsweep::diagnose::answer
