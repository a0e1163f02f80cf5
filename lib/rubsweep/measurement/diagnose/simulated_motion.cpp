#include "rubsweep/measurement/diagnose/simulated_motion.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "rubsweep/core/response/motion/record.hpp"
#include "rubsweep/core/response/settle.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/measurement/diagnose/lasting_motion.hpp"

namespace rubsweep::diagnose {
namespace {

int turns_after_verdict(const model::JeffcottRotor& rotor, double speed_hz, bool touches) {
  constexpr double left = 1e-5;
  const int decay = turns_to_decay(rotor.natural_frequency_hz, rotor.damping_ratio, speed_hz, left);
  return std::clamp(decay, fewest_turns_after_verdict,
                    touches ? most_turns_touching : most_turns_after_verdict);
}

}  // namespace

std::optional<SimulatedMotion> simulate_motion(const model::Machine& machine, double speed_hz,
                                               const scene::Unbalance& unbalance, int turns,
                                               response::motion::Workspace& workspace) {
  const scene::PreparedMachine prepared = scene::prepare_machine(machine);
  scene::Cell cell = scene::build_cell(prepared, speed_hz, unbalance);
  if (!scene::can_run(cell.start)) return std::nullopt;
  const integrate::run::SolverOptions solver;
  response::motion::ResponseOptions response;
  response.max_revolutions = 400;
  response.window_revolutions = 64;
  response.samples_per_revolution = samples_per_revolution;
  // Tells chaos from what is not decided, at a price.
  response.exponent = true;
  const response::SettledRun settled = response::settle(cell, solver, response, workspace);
  if (settled.outcome != integrate::run::Outcome::ok) return std::nullopt;
  SimulatedMotion motion{.motion_class = settled.motion.motion_class,
                         .order = settled.motion.order,
                         .proof = settled.proof,
                         .eccentricity_m = cell.eccentricity_m,
                         .whirl_ratio = cell.whirl_ratio,
                         .kicked = !cell.scene.pulses.empty()};
  // Set back to revolution 0 the run would be kicked again.
  cell.scene.pulses.clear();
  const bool touches = response::motion::row_of(settled.motion.motion_class).rubs;
  const int waiting = turns_after_verdict(std::get<model::JeffcottRotor>(machine.rotor), speed_hz, touches);
  auto record = response::motion::record_settled(cell.scene, solver, workspace.modes,
                                                 {.start = settled.section,
                                                  .settling = {.most_turns = waiting},
                                                  .turns = turns,
                                                  .samples_per_revolution = samples_per_revolution,
                                                  .peaks = true});
  if (!record) return std::nullopt;
  motion.displacement_m = std::move(record->displacement_m);
  motion.contact = record->contact;
  motion.rubs = record->touched;
  return motion;
}

}  // namespace rubsweep::diagnose
