#pragma once

#include <span>
#include <string>
#include <vector>

#include "rubsweep/analysis/branch/families/attribution.hpp"
#include "rubsweep/analysis/branch/families/family.hpp"
#include "rubsweep/maps/sweep/grid.hpp"

namespace rubsweep::apps {

/// Boundary lines of all families: family, kind, speed_hz and the map's unbalance. A row without numbers ends
/// a line.
std::string boundaries_csv(const sweep::Grid& grid, const std::vector<branch::families::Family>& families);

/// One row per family: order, impacts of its first cell, number of cells and area where the family exists,
/// and the share of these cells from which the kick reaches it.
std::string families_csv(const sweep::Grid& grid, const std::vector<branch::families::Family>& families);

/// One row per pair of neighbouring cells with different labels.
std::string edges_csv(const sweep::Grid& grid, std::span<const std::string> labels,
                      const std::vector<branch::families::MapEdge>& edges);

/// One row per checked label, except labels of cells whose kick leads to the family.
std::string contradictions_csv(const sweep::Grid& grid, std::span<const std::string> labels,
                               const std::vector<branch::families::LabelCheck>& checks);

/// Number of labels for each way in which they agree with the domains of the families or contradict them, for
/// a terminal.
std::string contradictions_summary(const std::vector<branch::families::LabelCheck>& checks);

/// Summary for a terminal: shares of the attributions, kinds of boundaries, and the cells that were not
/// followed.
std::string families_summary(const sweep::Grid& grid, const branch::families::Families& families,
                             std::size_t proven, const std::vector<branch::families::MapEdge>& edges);

}  // namespace rubsweep::apps
