#include "rubsweep/sweep/run_map.hpp"

#include "rubsweep/batch/parallel_run.hpp"
#include "rubsweep/sweep/evaluate_cell.hpp"

namespace rubsweep::sweep {

std::vector<std::optional<Row>> run_map(const Study& study, int threads,
                                        const std::function<void(const Row&)>& on_row,
                                        const std::atomic<bool>& stop) {
  std::vector<std::optional<Row>> rows(cell_count(study.grid));
  const auto run_cell = [&](std::size_t cell) {
    thread_local response::SpectrumWorkspace workspace;
    rows[cell] = evaluate_cell(study, cell, workspace);
  };
  batch::parallel_run(
      rows.size(), threads, run_cell, [&](std::size_t cell) { on_row(*rows[cell]); }, stop);
  return rows;
}

}  // namespace rubsweep::sweep
