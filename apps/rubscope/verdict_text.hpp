#pragma once

#include <string>

#include "rubsweep/core/model/length_text.hpp"
#include "rubsweep/measurement/scope/verdict.hpp"

namespace rubsweep::apps {

/// Class of the motion, its period and, with two probes, shape and whirl; without a line end.
std::string motion_text(const scope::Verdict& verdict);

/// Line about what remains doubtful because of noise and recording length. `shown`: unit of lengths.
std::string doubt_text(const scope::Verdict& verdict, double mean_speed_hz, const model::ShownLengths& shown);

/// Lines about slow variation and the lines outside the period or, without a period, about all lines. Empty
/// for a shaft at rest.
std::string content_text(const scope::Verdict& verdict, const model::ShownLengths& shown);

}  // namespace rubsweep::apps
