#pragma once

#include <string>

#include "rubsweep/sweep/study.hpp"

namespace rubsweep::sweep {

/// What a sweep simulates, what it leaves out and why, which solver runs it, and how a cell ends: text for a
/// terminal.
std::string explain(const Study& study);

}  // namespace rubsweep::sweep
