#include "rubsweep/maps/map/refined_cells.hpp"

#include "rubsweep/maps/report/describe_refinement.hpp"
#include "rubsweep/maps/report/map_summary.hpp"

namespace rubsweep::map {

RefinedCells::RefinedCells(const sweep::Grid& grid)
    : grid_(grid), labels_(sweep::cell_count(grid), sweep::unknown_label) {}

void RefinedCells::read(const MapDirectory& directory) {
  directory.for_each_finished([this](std::size_t cell, const std::string& line) { add(cell, line); });
}

void RefinedCells::add(std::size_t cell, const std::string& line) {
  labels_[cell] =
      numbers_.try_emplace(report::label_of(line), static_cast<int>(numbers_.size())).first->second;
}

std::vector<std::size_t> RefinedCells::wanted() const { return sweep::wanted_cells(grid_, labels_); }

std::string RefinedCells::description() const { return report::describe_refinement(grid_, labels_); }

}  // namespace rubsweep::map
