#pragma once

#include <span>
#include <string>
#include <vector>

#include "rubsweep/analysis/branch/families/attribution.hpp"
#include "rubsweep/analysis/branch/families/family.hpp"
#include "rubsweep/maps/sweep/grid.hpp"

namespace rubsweep::apps {

/// Lines of the boundaries of all families: family, kind, speed_hz and the map's unbalance; a row without
/// numbers ends a line.
std::string boundaries_csv(const sweep::Grid& grid, const std::vector<branch::families::Family>& families);

/// A row for every family: order, hits of its first cell, cells and area of existence, share that the kick
/// reaches.
std::string families_csv(const sweep::Grid& grid, const std::vector<branch::families::Family>& families);

/// A row for every pair of neighbouring cells with different labels.
std::string edges_csv(const sweep::Grid& grid, std::span<const std::string> labels,
                      const std::vector<branch::families::MapEdge>& edges);

/// A row for every label that was checked, but for those that the kick leads to.
std::string contradictions_csv(const sweep::Grid& grid, std::span<const std::string> labels,
                               const std::vector<branch::families::LabelCheck>& checks);

/// Number of labels that agree with the domains of the families, by finding, for a terminal.
std::string contradictions_summary(const std::vector<branch::families::LabelCheck>& checks);

/// Shares of the attributions, of the kinds of what ceases, and the cells that were not followed, for a
/// terminal.
std::string families_summary(const sweep::Grid& grid, const branch::families::Families& families,
                             std::size_t proven, const std::vector<branch::families::MapEdge>& edges);

}  // namespace rubsweep::apps
