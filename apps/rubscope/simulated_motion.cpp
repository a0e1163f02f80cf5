#include "simulated_motion.hpp"

#include <fmt/format.h>

#include <optional>

#include "rubsweep/analysis/page/settled_orbit.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/maps/sweep/evaluate_cell.hpp"
#include "rubsweep/maps/sweep/grid.hpp"

namespace rubsweep::apps {

SimulatedMotion simulate(const config::RunConfig& config, const CellArgument& cell) {
  sweep::Study study = config.study;
  study.grid = sweep::grid_of({cell.speed_hz, sweep::unbalance_of(study.grid, cell.unbalance)});
  const scene::PreparedMachine prepared = scene::prepare_machine(study.machine);
  response::motion::Workspace workspace;
  const sweep::Row row = sweep::evaluate_cell(study, prepared, 0, workspace);
  using response::motion::MotionClass;
  const bool every_turn =
      row.motion_class == MotionClass::non_contact || row.motion_class == MotionClass::synchronous;
  const std::optional<int> order = every_turn ? 1 : row.order;
  if (!order)
    throw ConfigError(
        fmt::format("--cell: the simulated motion is {} and repeats after no number of turns, allowed: a "
                    "cell whose motion does",
                    to_string(row.motion_class)));
  const page::KnownMotion known{
      .motion_class = to_string(row.motion_class),
      .order = order,
      .revolutions = row.revolutions,
      .hertz_force_n = row.hertz ? std::optional(row.hertz->force_n) : std::nullopt};
  const auto orbit = page::settled_orbit(study, prepared, 0, known, workspace);
  if (!orbit) throw ConfigError("--cell: the simulated cell has no motion, allowed: a cell that runs");
  SimulatedMotion motion{.period_m = {}, .turns = orbit->turns};
  // The last sample repeats the first one of the next period, so it is left out.
  for (std::size_t k = 0; k + 1 < orbit->signals[0].size(); ++k)
    motion.period_m.emplace_back(orbit->signals[0][k], orbit->signals[1][k]);
  return motion;
}

}  // namespace rubsweep::apps
