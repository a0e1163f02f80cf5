#include "rubsweep/maps/map/refined_cells.hpp"

#include <utility>

#include "rubsweep/maps/batch/csv_table.hpp"
#include "rubsweep/maps/map/map_files.hpp"
#include "rubsweep/maps/report/describe_grid.hpp"
#include "rubsweep/maps/report/map_cells.hpp"
#include "rubsweep/maps/report/map_summary.hpp"
#include "rubsweep/maps/sweep/refinement.hpp"

namespace rubsweep::map {
namespace {

/// Motions of the computed cells of a refined map.
struct ComputedMotions {
  std::vector<int> labels;           ///< labels of all cells; sweep::unknown_label if not computed
  std::vector<std::string> motions;  ///< class, order and kind of all cells; empty if not computed
};

ComputedMotions read_motions(const std::filesystem::path& map, const sweep::Grid& grid) {
  const std::size_t cells = sweep::cell_count(grid);
  ComputedMotions found{std::vector<int>(cells, sweep::unknown_label), std::vector<std::string>(cells)};
  batch::CsvReader rows(map);
  const std::size_t name = rows.column("class"), order = rows.column("order"), kind = rows.column("kind");
  report::CellsOfRows places(rows, grid);
  std::map<std::pair<std::string, std::string>, int> numbers;
  while (rows.next()) {
    const std::size_t cell = places.take(rows);
    const std::vector<std::string>& row = rows.cells();
    const auto [at, added] = numbers.try_emplace({row[name], row[order]}, static_cast<int>(numbers.size()));
    found.labels[cell] = at->second;
    const std::vector<std::string> motion{row[name], row[order], row[kind]};
    found.motions[cell] = batch::csv_row(motion);
  }
  return found;
}

std::string header(const sweep::Grid& grid) {
  std::vector<std::string> names;
  for (const sweep::KeyValue& column : sweep::columns_of_place(grid, 0)) names.push_back(column.key);
  return batch::csv_row(names) + ",class,order,kind,computed\n";
}

std::string axes_of(const sweep::Grid& grid, std::size_t cell) {
  std::vector<std::string> values;
  for (const sweep::KeyValue& column : sweep::columns_of_place(grid, cell))
    values.push_back(batch::csv_number(column.value));
  return batch::csv_row(values);
}

}  // namespace

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

void write_painted_map(const std::filesystem::path& map, const sweep::Grid& grid,
                       const batch::TableSource& source) {
  const ComputedMotions found = read_motions(map, grid);
  const std::vector<std::size_t> shown = sweep::shown_cells(grid, found.labels);
  batch::TableFile file(map.parent_path() / painted_map_file, source);
  file.write(header(grid));
  for (std::size_t cell = 0; cell < shown.size(); ++cell) {
    file.write(axes_of(grid, cell) + ',' + found.motions[shown[cell]] +
               (found.labels[cell] == sweep::unknown_label ? ",0\n" : ",1\n"));
  }
  file.finish();
  file.commit();
}

}  // namespace rubsweep::map
