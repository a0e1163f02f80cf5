#pragma once

#include <string>

#include "rubsweep/core/model/length_text.hpp"
#include "rubsweep/maps/sweep/row.hpp"

namespace rubsweep::apps {

/// The cell and its motion, one line each, from the row that the map holds of it: class, order, orbit, whirl
/// and what they rest on. The eccentricity as asked for, in m otherwise.
std::string motion_summary(const sweep::Row& row, const model::ShownLengths& shown = {});

}  // namespace rubsweep::apps
