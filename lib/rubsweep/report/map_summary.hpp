#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rubsweep/sweep/row.hpp"

namespace rubsweep::report {

/// Table for a terminal: cells per class and order, largest share first, then every status that is not `ok`.
std::string map_summary(const std::vector<std::optional<sweep::Row>>& rows);

}  // namespace rubsweep::report
