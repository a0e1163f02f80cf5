#pragma once

#include <string>

#include "rubsweep/core/model/length_text.hpp"
#include "rubsweep/maps/sweep/row.hpp"

namespace rubsweep::apps {

/// The cell and its motion from a row of the map, one line each: class, order, orbit, whirl and the evidence
/// for them. `shown`: unit of the eccentricity, m by default.
std::string motion_summary(const sweep::Row& row, const model::ShownLengths& shown = {});

}  // namespace rubsweep::apps
