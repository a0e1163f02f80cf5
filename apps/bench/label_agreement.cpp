#include "bench/label_agreement.hpp"

#include <numeric>

#include "bench/processor_time.hpp"
#include "bench/reference.hpp"

namespace rubsweep::bench {
namespace {

Label label_of(const scene::Cell& cell, const integrate::run::SolverOptions& solver,
               const response::motion::ResponseOptions& response, response::motion::Workspace& workspace) {
  const response::SettledRun run = response::settle(cell, solver, response, workspace);
  return {run.motion.motion_class, run.motion.order};
}

/// A step, near the golden ratio of `count`, that is coprime to it, so that repeated steps visit all cells.
std::size_t stride(std::size_t count) {
  auto step = static_cast<std::size_t>(0.618 * static_cast<double>(count)) + 1;
  while (std::gcd(step, count) != 1) ++step;
  return step;
}

}  // namespace

std::vector<LabelledCell> reference_labels(const model::Machine& machine,
                                           std::span<const scene::Place> places,
                                           const integrate::run::SolverOptions& base,
                                           const response::motion::ResponseOptions& response) {
  const integrate::run::SolverOptions solver = reference_options(base, label_tolerance);
  response::motion::Workspace workspace;
  std::vector<LabelledCell> cells;
  for (std::size_t i = 0; i < places.size(); ++i) {
    scene::Cell cell = scene::build_cell(machine, places[i].speed_hz, places[i].unbalance);
    if (!scene::can_run(cell.start)) continue;
    const Label label = label_of(cell, solver, response, workspace);
    cells.push_back({i, std::move(cell), label});
  }
  return cells;
}

LabelAgreement label_agreement(std::span<const LabelledCell> cells,
                               const integrate::run::SolverOptions& solver,
                               const response::motion::ResponseOptions& response, double seconds) {
  const double start = processor_time_s();
  LabelAgreement agreement;
  response::motion::Workspace workspace;
  if (cells.empty()) return agreement;
  const std::size_t step = stride(cells.size());
  for (std::size_t k = 0, i = 0; k < cells.size(); ++k, i = (i + step) % cells.size()) {
    if (processor_time_s() - start > seconds) {
      agreement.cut = true;
      break;
    }
    ++agreement.compared;
    if (label_of(cells[i].cell, solver, response, workspace) == cells[i].label) ++agreement.agreed;
  }
  return agreement;
}

std::vector<std::size_t> spread(std::size_t count, std::size_t wanted) {
  std::vector<std::size_t> indices;
  if (wanted >= count) {
    indices.resize(count);
    std::iota(indices.begin(), indices.end(), std::size_t{0});
  } else if (wanted == 1) {
    indices.push_back(count / 2);
  } else {
    for (std::size_t i = 0; i < wanted; ++i)
      indices.push_back((2 * i * (count - 1) + wanted - 1) / (2 * (wanted - 1)));
  }
  return indices;
}

}  // namespace rubsweep::bench
