#include "rubsweep/branch/settled_start.hpp"

#include "rubsweep/integrate/start.hpp"
#include "rubsweep/response/settle.hpp"

namespace rubsweep::branch {

SettledStart settle_on_orbit(const scene::Cell& cell, const integrate::run::SolverOptions& solver,
                             const response::motion::ResponseOptions& options,
                             response::motion::Workspace& workspace) {
  const response::SettledRun settled = response::settle(cell, solver, options, workspace);
  SettledStart start{settled.motion.motion_class, settled.motion.order, {}};
  if (!start.order) return start;
  // Once more, for its last section; where a proof ended the first run this one is as near to the orbit.
  const integrate::run::Run run = integrate::start(cell.scene, solver, workspace.modes);
  integrate::run::TurnReport turn;
  for (long revolution = 0; revolution < settled.revolutions; ++revolution) {
    if (run.advance({}, turn) == integrate::run::Outcome::ok) continue;
    start.order.reset();
    return start;
  }
  start.section =
      Eigen::Map<const Eigen::VectorXd>(turn.section.data(), static_cast<Eigen::Index>(turn.section.size()));
  return start;
}

}  // namespace rubsweep::branch
