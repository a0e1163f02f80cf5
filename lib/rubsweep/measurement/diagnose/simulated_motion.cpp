#include "rubsweep/measurement/diagnose/simulated_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <variant>

#include "rubsweep/core/integrate/exact/modes/mode_cache.hpp"
#include "rubsweep/core/response/motion/record.hpp"
#include "rubsweep/core/response/settle.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/core/structure/tabled_support.hpp"

namespace rubsweep::diagnose {
namespace {

constexpr int samples_of_a_turn = 32;

/// Whether a fixed number of modes of a kit suffices is not checked: that would take most of the time of a
/// short run.
scene::Cell cell_of(const model::Machine& machine, double speed_hz, const scene::Unbalance& unbalance) {
  const model::RotorKit* kit = model::kit_of(machine);
  if (!kit || !kit->modes) return scene::build_cell(machine, speed_hz, unbalance);
  return scene::build_cell(scene::prepare_with_modes(structure::machine_at(machine, speed_hz), *kit->modes),
                           speed_hz, unbalance);
}

std::optional<LastingMotion> record(const scene::Cell& cell, const response::motion::Settling& settling,
                                    int turns, response::spectrum::SpectrumWorkspace& workspace) {
  // The machine occurs only once, so a cache shared by all machines would only grow.
  integrate::exact::modes::ModeCache modes;
  // The tolerance counts where steppers make a contact; recordings are noisier.
  const integrate::run::SolverOptions solver{.relative_tolerance = 1e-6};
  const auto motion = response::motion::record_settled(
      cell.scene, solver, modes,
      {.settling = settling, .turns = turns, .samples_per_revolution = samples_of_a_turn, .peaks = true});
  if (!motion) return std::nullopt;
  return LastingMotion{lines_of(motion->displacement_m, turns, most_order, workspace), motion->contact,
                       cell.eccentricity_m};
}

int turns_after_verdict(const model::JeffcottRotor& rotor, double speed_hz, bool touches) {
  constexpr double left = 1e-5;
  const int decay = turns_to_decay(rotor.natural_frequency_hz, rotor.damping_ratio, speed_hz, left);
  return std::clamp(decay, fewest_turns_after_verdict,
                    touches ? most_turns_touching : most_turns_after_verdict);
}

}  // namespace

int turns_to_decay(double natural_frequency_hz, double damping_ratio, double speed_hz, double left) {
  constexpr double most = 1e6;
  const double turns =
      -std::log(left) * speed_hz / (2 * std::numbers::pi * damping_ratio * natural_frequency_hz);
  return static_cast<int>(std::ceil(std::min(turns, most)));
}

int turns_before_recording(const model::Machine& machine, double speed_hz) {
  const auto* rotor = std::get_if<model::JeffcottRotor>(&machine.rotor);
  if (!rotor) return kit_turns_before_recording;
  constexpr double left = 5e-3;
  return std::clamp(turns_to_decay(rotor->natural_frequency_hz, rotor->damping_ratio, speed_hz, left),
                    fewest_turns_before_recording, most_turns_before_recording);
}

std::optional<LastingMotion> rubbing_motion(const model::Machine& machine, double speed_hz,
                                            const scene::Unbalance& unbalance, int turns,
                                            response::spectrum::SpectrumWorkspace& workspace,
                                            std::optional<double> most_force_n) {
  const scene::Cell cell = cell_of(machine, speed_hz, unbalance);
  if (!scene::can_run(cell.start)) return std::nullopt;
  auto motion = record(cell,
                       {.most_turns = turns_before_recording(machine, speed_hz),
                        .longest_flight = turns_in_flight,
                        .most_force_n = most_force_n},
                       turns, workspace);
  if (motion && motion->contact.contact_fraction == 0) return std::nullopt;
  return motion;
}

std::optional<LastingMotion> motion_without_contact(const model::Machine& machine, double speed_hz,
                                                    const scene::Unbalance& unbalance, int turns,
                                                    response::spectrum::SpectrumWorkspace& workspace) {
  const scene::Cell cell = cell_of(machine, speed_hz, unbalance);
  if (cell.start != scene::Start::quiet) return std::nullopt;
  return record(cell, {}, turns, workspace);
}

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
  // The Lyapunov exponent separates chaos from undecided motion; it takes more time.
  response.exponent = true;
  const response::SettledRun settled = response::settle(cell, solver, response, workspace);
  if (settled.outcome != integrate::run::Outcome::ok) return std::nullopt;
  SimulatedMotion motion{.motion_class = settled.motion.motion_class,
                         .order = settled.motion.order,
                         .proof = settled.proof,
                         .eccentricity_m = cell.eccentricity_m,
                         .whirl_ratio = cell.whirl_ratio,
                         .kicked = !cell.scene.pulses.empty()};
  // The run goes on from revolution 0, where the pulses would act again.
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
