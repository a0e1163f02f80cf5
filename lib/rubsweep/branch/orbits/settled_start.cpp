#include "rubsweep/branch/orbits/settled_start.hpp"

#include <utility>

#include "rubsweep/branch/orbits/settled_oval.hpp"
#include "rubsweep/integrate/start.hpp"
#include "rubsweep/response/settle.hpp"

namespace rubsweep::branch::orbits {
namespace {

Eigen::VectorXd vector_of(const std::vector<double>& numbers) {
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
}

}  // namespace

SettledStart settle_on_orbit(const scene::Cell& cell, const integrate::run::SolverOptions& solver,
                             const response::motion::ResponseOptions& options,
                             response::motion::Workspace& workspace) {
  const response::SettledRun settled = response::settle(cell, solver, options, workspace);
  SettledStart start{settled.motion.motion_class, settled.motion.order, Closing::with_the_shaft, {}};
  if (start.motion_class == response::motion::MotionClass::quasi_periodic && !settled.section.empty()) {
    auto oval = oval_from(cell.scene, vector_of(settled.section), solver, options, workspace);
    if (oval) start = {start.motion_class, 1, Closing::in_the_turning_frame, std::move(*oval)};
    return start;
  }
  if (!start.order) return start;
  // Once more, for its last section; where a proof ended the first run this one is as near to the orbit.
  const integrate::run::Run run = integrate::start(cell.scene, solver, workspace.modes);
  integrate::run::TurnReport turn;
  for (long revolution = 0; revolution < settled.revolutions; ++revolution) {
    if (run.advance({}, turn) == integrate::run::Outcome::ok) continue;
    start.order.reset();
    return start;
  }
  start.state = vector_of(turn.section);
  return start;
}

}  // namespace rubsweep::branch::orbits
