#pragma once

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

#include "rubsweep/analysis/line/follow_line.hpp"

namespace rubsweep::line {

/// Cells at several speeds with the same machine and unbalance.
inline std::vector<LineCell> over_speed(const model::Machine& machine, const std::vector<double>& speeds_hz,
                                        const scene::Unbalance& unbalance) {
  sweep::Study study;
  study.machine = machine;
  const auto shared = std::make_shared<const sweep::Study>(study);
  const auto prepared = std::make_shared<const scene::PreparedMachine>(scene::prepare_machine(machine));
  std::vector<LineCell> cells;
  for (const double speed_hz : speeds_hz)
    cells.push_back({speed_hz, shared, prepared, {speed_hz, unbalance}});
  return cells;
}

/// All points, sorted by pass and then by cell.
inline std::vector<LinePoint> followed(const std::vector<LineCell>& cells, const std::vector<Pass>& passes,
                                       int threads = 1) {
  std::vector<LinePoint> points;
  const std::atomic<bool> stop{false};
  follow_line(
      cells, passes, threads, [&](LinePoint&& point) { points.push_back(std::move(point)); }, stop);
  std::ranges::sort(points, {}, [](const LinePoint& point) { return std::pair(point.pass, point.cell); });
  return points;
}

}  // namespace rubsweep::line
