#include "rubsweep/maps/sweep/run_cells.hpp"

#include "rubsweep/maps/batch/parallel_run.hpp"
#include "rubsweep/maps/sweep/evaluate_cell.hpp"

namespace rubsweep::sweep {
namespace {

thread_local response::motion::Workspace workspace;
/// passed to on_row by the thread that computed it, before this thread takes another cell
thread_local Row latest;

}  // namespace

std::size_t run_cells(const Study& study, std::span<const std::size_t> cells, int threads,
                      const std::function<void(std::size_t cell, const Row&)>& on_row,
                      const std::atomic<bool>& stop) {
  return run_cells(study, scene::prepare_machine(study.machine), cells, threads, on_row, stop);
}

std::size_t run_cells(const Study& study, const scene::PreparedMachine& prepared,
                      std::span<const std::size_t> cells, int threads,
                      const std::function<void(std::size_t cell, const Row&)>& on_row,
                      const std::atomic<bool>& stop) {
  return batch::parallel_run(
      cells.size(), threads,
      [&](std::size_t i) { latest = evaluate_cell(study, prepared, cells[i], workspace); },
      [&](std::size_t i) { on_row(cells[i], latest); }, stop);
}

}  // namespace rubsweep::sweep
