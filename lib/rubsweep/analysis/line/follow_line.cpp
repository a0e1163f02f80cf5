#include "rubsweep/analysis/line/follow_line.hpp"

#include <algorithm>
#include <mutex>
#include <utility>

#include "rubsweep/core/error.hpp"
#include "rubsweep/maps/batch/parallel_run.hpp"
#include "rubsweep/maps/sweep/evaluate_cell.hpp"

namespace rubsweep::line {
namespace {

thread_local response::motion::Workspace workspace;

/// Lets the cell start in a state of its neighbour.
void start_from(scene::Cell& cell, const HandedState& state) {
  cell.scene.pulses.clear();
  cell.scene.displacement_m = state.displacement_m;
  cell.scene.velocity_m_per_s = cell.scene.speed_rad_per_s * state.velocity_m_per_rad;
}

LinePoint run_cell(const LineCell& line_cell, Pass pass, std::size_t number,
                   const std::optional<HandedState>& before) {
  const sweep::Study& study = *line_cell.study;
  const double speed_hz = line_cell.place.speed_hz;
  // A state that is handed on needs the same coordinates at all speeds; a kicked cell is that of a map.
  scene::Cell cell = scene::build_cell(
      pass == Pass::kick ? scene::prepared_at(*line_cell.machine, speed_hz) : *line_cell.machine, speed_hz,
      line_cell.place.unbalance);
  LinePoint point{pass, number, {}, std::nullopt};
  if (!scene::can_run(cell.start)) {
    point.row = sweep::row_of(cell, speed_hz, study.machine, nullptr);
    return point;
  }
  if (before) start_from(cell, *before);
  const response::SettledRun run = response::settle(cell, study.solver, study.response, workspace);
  point.row = sweep::row_of(cell, speed_hz, study.machine, &run);
  if (before) point.row.start = sweep::RunStart::handed_on;
  point.motion = settled_motion(cell, run, study, workspace);
  return point;
}

void refuse_other_coordinates(std::span<const LineCell> cells) {
  const auto coordinates = [](const LineCell& cell) { return cell.machine->assembly.system.coordinates(); };
  for (const LineCell& cell : cells) {
    if (coordinates(cell) == coordinates(cells.front())) continue;
    throw ConfigError(
        "--up, --down: the number of coordinates changes along the line, so that no state can be handed on, "
        "allowed: --kick");
  }
}

}  // namespace

std::size_t follow_line(std::span<const LineCell> cells, std::span<const Pass> passes, int threads,
                        const std::function<void(LinePoint&&)>& on_point, const std::atomic<bool>& stop) {
  std::vector<Pass> chains;
  for (const Pass pass : passes)
    if (pass != Pass::kick) chains.push_back(pass);
  if (!chains.empty()) refuse_other_coordinates(cells);
  const bool kicked = std::ranges::find(passes, Pass::kick) != passes.end();
  std::mutex mutex;
  std::size_t finished = 0;
  const auto deliver = [&](LinePoint&& point) {
    const std::lock_guard lock(mutex);
    on_point(std::move(point));
    ++finished;
  };
  const auto run_chain = [&](Pass pass) {
    std::optional<HandedState> before;
    for (std::size_t i = 0; i < cells.size() && !stop; ++i) {
      const std::size_t number = pass == Pass::up ? i : cells.size() - 1 - i;
      LinePoint point = run_cell(cells[number], pass, number, before);
      before = point.motion ? std::optional(point.motion->end) : std::nullopt;
      deliver(std::move(point));
    }
  };
  // A chain takes as long as many cells: it begins first.
  batch::parallel_run(
      chains.size() + (kicked ? cells.size() : 0), threads,
      [&](std::size_t task) {
        if (task < chains.size()) {
          run_chain(chains[task]);
        } else {
          const std::size_t number = task - chains.size();
          deliver(run_cell(cells[number], Pass::kick, number, std::nullopt));
        }
      },
      [](std::size_t) {}, stop);
  return finished;
}

}  // namespace rubsweep::line
