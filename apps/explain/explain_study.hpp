#pragma once

#include <string>

#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::apps {

/// Explanation of a sweep for a terminal: the model, its omissions and their reasons, the solver, and how a
/// cell ends.
std::string explain_study(const sweep::Study& study);

}  // namespace rubsweep::apps
