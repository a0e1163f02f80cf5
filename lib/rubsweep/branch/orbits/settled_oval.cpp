#include "rubsweep/branch/orbits/settled_oval.hpp"

#include "rubsweep/branch/orbits/oval_orbits.hpp"
#include "rubsweep/integrate/start.hpp"
#include "rubsweep/response/proof/section_map.hpp"
#include "rubsweep/response/rotating/apex_return_search.hpp"
#include "rubsweep/response/rotating/limit_cycle.hpp"
#include "rubsweep/response/rotating/rotating_frame.hpp"
#include "rubsweep/response/rotating/symmetry.hpp"

namespace rubsweep::branch::orbits {

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

}  // namespace rubsweep::branch::orbits
