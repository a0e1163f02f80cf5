#include "rubsweep/core/response/settle.hpp"

#include <algorithm>
#include <array>
#include <complex>
#include <numbers>
#include <variant>

#include "rubsweep/core/contact/wall.hpp"
#include "rubsweep/core/integrate/run/pulse_times.hpp"
#include "rubsweep/core/integrate/run/state_scale.hpp"
#include "rubsweep/core/integrate/run/work_bound.hpp"
#include "rubsweep/core/response/aperiodic.hpp"
#include "rubsweep/core/response/motion/record.hpp"
#include "rubsweep/core/response/proof/orbit_proof.hpp"
#include "rubsweep/core/response/proof/rest_proof.hpp"
#include "rubsweep/core/response/rotating/rotating_proof.hpp"
#include "rubsweep/core/response/verdict.hpp"

namespace rubsweep::response {
namespace {

using Complex = std::complex<double>;

/// Proof that a transient settles on a motion; a rotationally symmetric scene is examined in the rotating
/// frame.
class MotionProof {
 public:
  MotionProof(const scene::Scene& scene, const SceneFacts& facts, const integrate::run::SolverOptions& solver,
              const motion::ResponseOptions& options, motion::Workspace& workspace)
      : budget_(share_for_proofs *
                integrate::run::most_work_of_a_run(solver, scene.structure.coordinates())) {
    if (!options.floquet_proof || !facts.same_every_turn) return;
    if (facts.rotationally_symmetric) {
      proof_.emplace<rotating::RotatingProof>(scene, solver, options, workspace, budget_);
    } else {
      proof_.emplace<proof::OrbitProof>(scene, solver, options, workspace, budget_);
    }
  }

  int samples_wanted() const {
    const auto* turning = std::get_if<rotating::RotatingProof>(&proof_);
    return turning ? turning->samples_wanted() : 0;
  }

  std::optional<motion::ProvenMotion> look(const integrate::run::TurnReport& turn) {
    if (auto* turning = std::get_if<rotating::RotatingProof>(&proof_)) return turning->look(turn);
    if (auto* section = std::get_if<proof::OrbitProof>(&proof_)) return section->look(turn);
    return std::nullopt;
  }

 private:
  /// Share of a run's work that proofs may take; their purpose is to make the run shorter.
  static constexpr double share_for_proofs = 0.5;

  integrate::run::WorkBudget budget_;
  std::variant<std::monostate, proof::OrbitProof, rotating::RotatingProof> proof_;
};

void conclude(const motion::ProvenMotion& proven, SettledRun& run) {
  run.motion.motion_class = proven.motion_class;
  run.motion.order = proven.order;
  run.motion.measures = proven.measures;
  run.proof = proven.proof;
  run.floquet_modulus = proven.floquet_modulus;
}

void conclude(const Verdict& seen, const scene::Cell& cell, const proof::RestProof& rest, SettledRun& run) {
  run.motion = seen.motion;
  run.survival = seen.survival;
  // Two windows without contact do not prove rest where the quiet motion itself touches, or where a free
  // vibration grows, for example by rotating damping: the whirl then continues to grow.
  const bool lasts = cell.start == scene::Start::quiet && !rest.vibration_grows();
  if (run.motion.motion_class == motion::MotionClass::non_contact && !lasts)
    run.motion.motion_class = motion::MotionClass::unsettled;
  if (run.motion.motion_class != motion::MotionClass::unsettled) run.proof = motion::Proof::observed;
}

/// Whether the search for a torus saves time. Turns are expensive at annular stops, whereas a full run
/// between flat stops costs less than the tangent vector of the search.
bool worth_watching(const scene::Scene& scene, const SceneFacts& facts,
                    const motion::ResponseOptions& options, double kick_turns) {
  const bool annular =
      std::ranges::any_of(scene.contacts, [](const scene::Contact& c) { return contact::annular(c.wall); });
  return annular && options.floquet_proof && kick_turns <= TorusWatch::settled_after &&
         facts.same_every_turn && !facts.rotationally_symmetric;
}

/// Whether the window after a torus was found shows neither a period nor rest.
bool conclude_on_torus(TorusWatch& torus, const motion::Record& record,
                       const motion::ResponseOptions& options, motion::Workspace& workspace,
                       SettledRun& run) {
  const auto window = motion::classify_window(record.window(0), options, workspace.spectrum);
  if (!may_be_aperiodic(window)) {
    torus.refuse();
    return false;
  }
  run.motion = motion::settle_verdict(window, window);
  run.motion.motion_class = motion::MotionClass::quasi_periodic;
  run.motion.exponent = torus.torus();
  run.proof = motion::Proof::observed;
  return true;
}

/// A stopped run has windows of at least 2 turns and of at most an eighth of its turns: they are computed
/// again.
constexpr int shortest_window = 2, windows_of_a_run = 8;

/// Concludes a run that reached a limit of work: its last two windows give its measures.
void conclude_stopped(const scene::Cell& cell, const integrate::run::SolverOptions& solver,
                      motion::ResponseOptions options, const Checkpoints& passed, double kick_turns,
                      motion::Workspace& workspace, SettledRun& run) {
  run.motion.motion_class = motion::MotionClass::failed;
  const double turns = static_cast<double>(run.revolutions) - kick_turns;
  if (run.outcome != integrate::run::Outcome::step_limit || turns < 2 * shortest_window) return;
  options.window_revolutions =
      std::clamp(static_cast<int>(turns / windows_of_a_run), shortest_window, options.window_revolutions);
  options.max_order = std::min(options.max_order, options.window_revolutions / 2);
  const auto& from = passed.before(run.revolutions - 2L * options.window_revolutions);
  const auto record = recorded_run(integrate::run::scene_at(cell.scene, from.section, from.revolutions),
                                   solver, options, run.revolutions - from.revolutions, workspace);
  if (!record) return;
  run.outcome = integrate::run::Outcome::ok;
  run.motion = {};
  run.motion.measures = motion::classify_window(record->window(1), options, workspace.spectrum).measures;
  run.motion.status = motion::MotionStatus::step_limit;
}

void conclude_at_rest(const scene::Cell& cell, const motion::ResponseOptions& options,
                      motion::Workspace& workspace, SettledRun& run) {
  run.motion.motion_class = motion::MotionClass::non_contact;
  run.motion.measures = quiet_measures(cell, options, workspace);
  run.proof = motion::Proof::rest;
}

}  // namespace

SettledRun settle(const scene::Cell& cell, const integrate::run::SolverOptions& solver,
                  const motion::ResponseOptions& options, motion::Workspace& workspace) {
  SettledRun run;
  const integrate::run::Run motion = integrate::start(cell.scene, solver, workspace.modes);
  proof::RestProof rest(cell, workspace.forms);
  run.rotor_unstable = rest.vibration_grows();
  const SceneFacts facts(cell.scene);
  MotionProof proof(cell.scene, facts, solver, options, workspace);
  const double most_work = integrate::run::most_work_of_a_run(solver, cell.scene.structure.coordinates());
  const double kick_turns =
      integrate::run::pulses_end_s(cell.scene) * cell.scene.speed_rad_per_s / (2 * std::numbers::pi);
  TorusWatch torus(cell.scene, options, worth_watching(cell.scene, facts, options, kick_turns));
  motion::Record record(cell.scene, options);
  Checkpoints passed(options.window_revolutions, integrate::run::scaled_initial_state(cell.scene));
  integrate::run::TurnRequest request;
  integrate::run::TurnReport turn;
  while (run.revolutions < options.max_revolutions) {
    const long first_recorded = torus.record_begin();
    request.samples_per_revolution = proof.samples_wanted();
    if (run.revolutions >= first_recorded) request.samples_per_revolution = options.samples_per_revolution;
    request.peaks = run.revolutions >= first_recorded;
    torus.ask(run.revolutions, request);
    if (run.revolutions == first_recorded) {
      record.begin(first_recorded == 0 ? integrate::run::scaled_initial_state(cell.scene) : turn.section);
    }
    run.outcome = motion.advance(request, turn);
    run.effort = turn.effort;
    // A failed turn is included, because a slip reversal may be the reason of the failure.
    run.slip_reversed = run.slip_reversed || turn.slip_reversed;
    if (run.outcome == integrate::run::Outcome::ok && integrate::run::work(turn.effort) > most_work)
      run.outcome = integrate::run::Outcome::step_limit;
    if (run.outcome != integrate::run::Outcome::ok) {
      conclude_stopped(cell, solver, options, passed, kick_turns, workspace, run);
      return run;
    }
    ++run.revolutions;
    passed.pass(run.revolutions, turn.section);
    torus.add(request, turn);
    run.section = turn.section;
    if (turn.touched) run.last_contact_revolution = run.revolutions;
    if (run.revolutions > first_recorded) record.add(turn);
    if (static_cast<double>(run.revolutions) < kick_turns) continue;
    if (const auto proven = proof.look(turn)) {
      conclude(*proven, run);
      return run;
    }
    if (!turn.touching_at_end && rest.proves(turn.section)) {
      conclude_at_rest(cell, options, workspace, run);
      return run;
    }
    if (run.revolutions == options.max_revolutions) break;
    if (run.revolutions == torus.next_look()) torus.look(workspace.spectrum);
    if (torus.torus() && run.revolutions == torus.record_begin() + options.window_revolutions &&
        conclude_on_torus(torus, record, options, workspace, run))
      return run;
  }
  conclude(verdict_of(cell.scene, facts, solver, options, record, turn.section, torus, workspace), cell, rest,
           run);
  return run;
}

motion::Measures quiet_measures(const scene::Cell& cell, const motion::ResponseOptions& options,
                                motion::Workspace& workspace) {
  const auto displacement_m = motion::quiet_samples(cell, options.samples_per_revolution);
  double peak = 0;
  for (const Complex& z : displacement_m) peak = std::max(peak, Eigen::Vector2d(z.real(), z.imag()).norm());
  // No force that turns with the shaft moves a casing without contact.
  double casing = 0;
  for (const scene::Contact& contact : cell.scene.contacts) {
    if (!contact.casing_point) continue;
    const auto& point = cell.scene.structure.points[static_cast<std::size_t>(*contact.casing_point)];
    casing = std::max(casing, (point.map * cell.quiet.mean).norm());
  }
  const std::array<double, 2> rest{0, 0};
  motion::Window window;
  window.turns = 1;
  window.samples_per_revolution = options.samples_per_revolution;
  window.clearance_m = cell.scene.length_scale_m;
  window.displacement_m = displacement_m;
  window.states = 1;
  window.section = rest;
  const std::array<motion::ContactFacts, 1> facts{
      {{.peak_displacement_m = peak, .peak_casing_displacement_m = casing}}};
  window.contact = facts;
  return motion::classify_window(window, options, workspace.spectrum).measures;
}

}  // namespace rubsweep::response
