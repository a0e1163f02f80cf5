#include "rubsweep/sweep/run_map.hpp"

#include <numeric>

#include "rubsweep/sweep/evaluate_cell.hpp"
#include "rubsweep/sweep/run_cells.hpp"

namespace rubsweep::sweep {

std::vector<std::optional<Row>> run_map(const Study& study, int threads,
                                        const std::function<void(const Row&)>& on_row,
                                        const std::atomic<bool>& stop) {
  std::vector<std::optional<Row>> rows(cell_count(study.grid));
  std::vector<std::size_t> cells(rows.size());
  std::iota(cells.begin(), cells.end(), std::size_t{0});
  run_cells(
      study, cells, threads,
      [&](std::size_t cell, const Row& row) {
        rows[cell] = row;
        on_row(row);
      },
      stop);
  return rows;
}

}  // namespace rubsweep::sweep
