#pragma once

#include <string>

#include "rubsweep/sweep/study.hpp"

namespace rubsweep::report {

/// What a sweep simulates, what it leaves out and why, which solver runs it, and how a cell ends: text for a
/// terminal.
std::string explain_study(const sweep::Study& study);

}  // namespace rubsweep::report
