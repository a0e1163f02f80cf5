// The branch of periodic orbits through one cell: where it folds, doubles its period or grazes a wall, as
// speed_hz changes.
//
//     branch CONFIG SPEED_HZ UNBALANCE LOW_HZ HIGH_HZ
//
// The unbalance is given as in the configuration's sweep: as whirl ratio or as eccentricity in metres. Stable
// and unstable orbits are followed, as rubbranch does.

#include "rubsweep/branch.hpp"

#include <cstdio>
#include <cstdlib>
#include <exception>

#include "rubsweep/configuration.hpp"

namespace {

using namespace rubsweep;
namespace orbits = branch::orbits;
namespace continuation = branch::continuation;

struct Span {
  double low_hz = 0, high_hz = 0;
};

int follow(const sweep::Study& study, double speed_hz, double value, Span span) {
  const scene::PreparedMachine prepared = scene::prepare_machine(study.machine);
  const scene::Unbalance unbalance = sweep::unbalance_of(study.grid, value);
  const scene::Cell cell = scene::build_cell(prepared, speed_hz, unbalance);
  if (!scene::can_run(cell.start)) {
    std::puts("the cell has no motion that could be run");
    return 4;
  }

  // The cell is run from its kick until its motion is known to be a periodic orbit of `order` turns.
  response::motion::Workspace workspace;
  const orbits::SettledStart settled = orbits::settle_on_orbit(cell, study.solver, study.response, workspace);
  if (!settled.order) {
    std::puts("the cell settles on no periodic orbit in contact");
    return 4;
  }

  // The parameter of the branch is the speed.
  const auto scene_at = [&](double hz) { return scene::build_cell(prepared, hz, unbalance).scene; };
  orbits::OrbitProblem problem =
      orbits::closed_orbits(settled.closing, scene_at, *settled.order, study.solver, workspace.modes);
  problem.low = span.low_hz;
  problem.high = span.high_hz;
  problem.parameter_scale = span.high_hz - span.low_hz;

  const auto start = continuation::orbit_from(problem, settled.state, speed_hz);
  if (!start) {
    std::puts("Newton's iteration does not find the orbit that the cell settles on");
    return 4;
  }
  const continuation::Branch found = continuation::follow_both_ways(problem, *start, {});
  std::printf("%zu orbits\n%s", found.points.size(),
              continuation::branch_summary("speed_hz", {found}).c_str());
  return 0;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 6) {
    std::fputs("usage: branch CONFIG SPEED_HZ UNBALANCE LOW_HZ HIGH_HZ\n", stderr);
    return 1;
  }
  try {
    return follow(rubsweep::config::read_run_config(arguments[1], {}).study, std::atof(arguments[2]),
                  std::atof(arguments[3]), {std::atof(arguments[4]), std::atof(arguments[5])});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "branch: %s\n", error.what());
    return 2;
  }
}
