#pragma once

#include <string>

#include "rubsweep/sweep/row.hpp"

namespace rubsweep::report {

/// The cell and its motion, one line each, from the row that the map holds of it: class, order, orbit, whirl
/// and what they rest on.
std::string motion_summary(const sweep::Row& row);

}  // namespace rubsweep::report
