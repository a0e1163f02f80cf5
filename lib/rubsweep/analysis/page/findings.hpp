#pragma once

#include <string>
#include <vector>

#include "rubsweep/analysis/page/map_table.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::page {

/// Findings of a map, one sentence each, for people: size, share and extent of lasting rub, its most frequent
/// motion, the largest force and displacement, chaos, what is proven, and which cells say little.
std::vector<std::string> findings(const MapTable& map, const sweep::Grid& grid);

}  // namespace rubsweep::page
