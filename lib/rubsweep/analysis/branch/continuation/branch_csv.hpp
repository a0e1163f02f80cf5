#pragma once

#include <string>
#include <vector>

#include "rubsweep/analysis/branch/continuation/branch_point.hpp"

namespace rubsweep::branch::continuation {

/// `#` lines of both files: the meaning of the parameter, and the ending of each branch.
std::string branch_comments(const std::string& parameter, const std::vector<Branch>& branches);

/// Header and a row for every point, branch by branch, by ascending arclength.
std::string branch_csv(const std::vector<Branch>& branches);

/// Header and a row for every event, the same way.
std::string branch_events_csv(const std::vector<Branch>& branches);

/// Summary for a terminal: the extent of each branch, and its events.
std::string branch_summary(const std::string& parameter, const std::vector<Branch>& branches);

}  // namespace rubsweep::branch::continuation
