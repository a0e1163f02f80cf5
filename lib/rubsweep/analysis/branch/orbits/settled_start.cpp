#include "rubsweep/analysis/branch/orbits/settled_start.hpp"

#include <utility>

#include "rubsweep/analysis/branch/orbits/oval_orbits.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "rubsweep/core/response/motion/record.hpp"
#include "rubsweep/core/response/proof/section_map.hpp"
#include "rubsweep/core/response/rotating/apex_return_search.hpp"
#include "rubsweep/core/response/rotating/limit_cycle.hpp"
#include "rubsweep/core/response/rotating/rotating_frame.hpp"
#include "rubsweep/core/response/settle.hpp"

namespace rubsweep::branch::orbits {
namespace {

Eigen::VectorXd vector_of(const std::vector<double>& numbers) {
  return Eigen::Map<const Eigen::VectorXd>(numbers.data(), static_cast<Eigen::Index>(numbers.size()));
}

}  // namespace

using Eigen::VectorXd;
namespace rotating = response::rotating;

std::optional<VectorXd> oval_from(const scene::Scene& with_pulses, const VectorXd& section,
                                  const integrate::run::SolverOptions& solver,
                                  const response::motion::ResponseOptions& options,
                                  response::motion::Workspace& workspace) {
  if (!rotating::rotationally_symmetric(with_pulses)) return std::nullopt;
  const scene::Scene scene = response::proof::after_the_kick(with_pulses);
  const rotating::RotatingField field(scene, solver);
  const rotating::CycleFlows flows(scene, solver, 0);
  const rotating::RotatingMotion motion = flows.motion(field);
  const integrate::run::Run run = integrate::start(scene, solver, workspace.modes);
  run.restart({section.data(), static_cast<std::size_t>(section.size())});
  rotating::ApexReturnSearch search(scene);
  integrate::run::TurnRequest request;
  request.samples_per_revolution = options.samples_per_revolution;
  integrate::run::TurnReport turn;
  for (int revolution = 0; revolution < options.max_revolutions; ++revolution) {
    if (run.advance(request, turn) != integrate::run::Outcome::ok) return std::nullopt;
    search.add(turn);
    const auto candidate = search.candidate();
    if (!candidate) continue;
    const VectorXd here =
        Eigen::Map<const VectorXd>(turn.section.data(), static_cast<Eigen::Index>(turn.section.size()));
    if (const auto cycle = rotating::prove_limit_cycle(motion, here, candidate->periods_rad))
      return oval_state(scene, solver, cycle->state, cycle->once.angle_rad);
    search.refuse(*candidate);
  }
  return std::nullopt;
}

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
  // Second run, to get the last section. Where a proof ended the first run, the second run ends equally near
  // the orbit.
  const integrate::run::Run run = integrate::start(cell.scene, solver, workspace.modes);
  integrate::run::TurnReport turn;
  if (response::motion::pass_until_settled(run, {.most_turns = settled.revolutions}, turn)) {
    start.state = vector_of(turn.section);
  } else {
    start.order.reset();
  }
  return start;
}

}  // namespace rubsweep::branch::orbits
