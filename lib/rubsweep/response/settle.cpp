#include "rubsweep/response/settle.hpp"

#include <algorithm>
#include <array>
#include <complex>
#include <functional>
#include <numbers>
#include <variant>
#include <vector>

#include "rubsweep/contact/wall.hpp"
#include "rubsweep/integrate/run/impulses.hpp"
#include "rubsweep/integrate/run/state_scale.hpp"
#include "rubsweep/integrate/run/work_bound.hpp"
#include "rubsweep/response/aperiodic.hpp"
#include "rubsweep/response/motion/record.hpp"
#include "rubsweep/response/proof/orbit_proof.hpp"
#include "rubsweep/response/proof/rest_proof.hpp"
#include "rubsweep/response/proof/section_map.hpp"
#include "rubsweep/response/rotating/rotating_proof.hpp"
#include "rubsweep/response/rotating/symmetry.hpp"
#include "rubsweep/response/spectrum/comb.hpp"
#include "rubsweep/response/spectrum/comb_line.hpp"
#include "rubsweep/response/torus_watch.hpp"

namespace rubsweep::response {
namespace {

using Complex = std::complex<double>;

/// A hundredth of `separation`: the solver's noise must not part the states.
constexpr double largest_tolerance_of_an_exponent = 1e-7;

/// Properties of a scene that decide how it is looked at, computed once a run.
struct SceneFacts {
  bool rotationally_symmetric = false;
  bool same_every_turn = false;  ///< the impulses

  explicit SceneFacts(const scene::Scene& scene)
      : rotationally_symmetric(rotating::rotationally_symmetric(scene)),
        same_every_turn(integrate::run::same_every_turn(scene.impulses)) {}
};

/// End of the last pulse.
double pulses_end_s(const scene::Scene& scene) {
  double end_s = 0;
  for (const scene::Pulse& pulse : scene.pulses) end_s = std::max(end_s, pulse.duration_s - pulse.elapsed_s);
  return end_s;
}

const Eigen::Matrix<double, 2, Eigen::Dynamic>& observed(const scene::Scene& scene) {
  return scene.structure.points[static_cast<std::size_t>(scene.observed_point)].map;
}

void look_for_comb(const motion::Record& record, const motion::ResponseOptions& options,
                   motion::Workspace& workspace, motion::Motion& motion) {
  if (2 * options.window_revolutions < spectrum::fewest_comb_turns) return;
  const auto comb =
      spectrum::find_comb(record.displacement_m(), options.samples_per_revolution, workspace.spectrum);
  if (!comb) return;
  const bool holds_the_energy = comb->closed || comb->energy_share >= spectrum::oval_energy_share;
  if (motion.measures.orbit == spectrum::OrbitKind::complex && holds_the_energy)
    motion.measures.orbit = spectrum::OrbitKind::oval;
  if (!comb->closed) return;
  motion.motion_class = motion::MotionClass::quasi_periodic;
  motion.measures.comb_spacing = comb->spacing;
  if (!motion.measures.dominant) return;
  motion.measures.dominant =
      spectrum::largest_comb_line(record.displacement_m(), options.samples_per_revolution, comb->spacing);
}

/// Verdict at the end of a whole run.
struct Verdict {
  motion::Motion motion;
  std::optional<Survival> survival;  ///< of chaos
};

/// Measures how long chaos lasts that `followed` is a stretch of.
void ask_how_long_it_lasts(proof::SceneMap& map, const motion::ResponseOptions& options,
                           const Followed& followed, Verdict& verdict) {
  verdict.survival =
      survive([&map](std::span<double> section) { return map(section); }, [&map] { return map.touched(); },
              followed, {.window = options.window_revolutions, .max_order = options.max_order});
  if (verdict.survival->escapes > 0) verdict.motion.status = motion::MotionStatus::transient_chaos;
}

void follow_on(const scene::Scene& scene, integrate::run::SolverOptions solver,
               const motion::ResponseOptions& options, std::span<const double> section,
               motion::Workspace& workspace, integrate::run::WorkBudget& budget, Verdict& verdict) {
  motion::Motion& motion = verdict.motion;
  solver.relative_tolerance = std::min(solver.relative_tolerance, largest_tolerance_of_an_exponent);
  proof::SceneMap map(scene, solver, workspace.modes, &budget);
  const Aperiodic found = classify_aperiodic(
      tangent_growth(map), [&map] { return map.touched(); }, {section.begin(), section.end()},
      static_cast<std::size_t>(options.max_revolutions), observed(scene), options.window_revolutions,
      workspace.spectrum);
  motion.motion_class = found.motion_class;
  motion.exponent = found.exponent;
  if (budget.used_up()) motion.status = motion::MotionStatus::step_limit;
  if (found.left_chaos) motion.status = motion::MotionStatus::transient_chaos;
  if (found.returns_after.value_or(0) > options.max_order)
    motion.status = motion::MotionStatus::order_above_max;
  if (found.motion_class == motion::MotionClass::chaotic)
    ask_how_long_it_lasts(map, options, found.motion, verdict);
}

/// Whether the motion at the end of the run may have no period: the window shows neither a period nor rest.
bool may_be_aperiodic(const motion::WindowVerdict& verdict) {
  return verdict.motion_class == motion::MotionClass::unsettled && !verdict.period;
}

/// Verdict at the end of the run; `section` is that of its last turn, `watch` what was seen on the way there.
Verdict verdict_of(const scene::Scene& scene, const SceneFacts& facts,
                   const integrate::run::SolverOptions& solver, const motion::ResponseOptions& options,
                   const motion::Record& record, std::span<const double> section, const TorusWatch& watch,
                   motion::Workspace& workspace) {
  const motion::WindowVerdict previous =
      motion::classify_window(record.window(0), options, workspace.spectrum);
  const motion::WindowVerdict last = motion::classify_window(record.window(1), options, workspace.spectrum);
  Verdict verdict{motion::settle_verdict(previous, last), {}};
  motion::Motion& motion = verdict.motion;
  if (!may_be_aperiodic(previous) || !may_be_aperiodic(last)) return verdict;
  if (facts.rotationally_symmetric) look_for_comb(record, options, workspace, motion);
  if (!options.exponent || motion.motion_class != motion::MotionClass::unsettled || !facts.same_every_turn)
    return verdict;
  integrate::run::WorkBudget budget(
      integrate::run::most_work_of_a_run(solver, scene.structure.coordinates()));
  if (const auto chaos = watch.chaos()) {
    motion.motion_class = motion::MotionClass::chaotic;
    motion.exponent = chaos;
    proof::SceneMap map(scene, solver, workspace.modes, &budget);
    ask_how_long_it_lasts(map, options, watch.motion(), verdict);
  } else {
    follow_on(scene, solver, options, section, workspace, budget, verdict);
  }
  return verdict;
}

/// Proof that a transient settles on a motion: a rotationally symmetric scene is looked at in the frame that
/// turns with the shaft.
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
  /// Share of the work of a run: proofs are there to make it shorter.
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
  // Two windows without contact do not last where the quiet motion itself touches, or where a vibration about
  // it grows, as by damping that turns with the shaft: the whirl is still growing.
  const bool lasts = cell.start == scene::Start::quiet && !rest.vibration_grows();
  if (run.motion.motion_class == motion::MotionClass::non_contact && !lasts)
    run.motion.motion_class = motion::MotionClass::unsettled;
  if (run.motion.motion_class != motion::MotionClass::unsettled) run.proof = motion::Proof::observed;
}

/// Where turns are dear, which is at annular stops: between flat ones a run to its end costs less than the
/// tangent vector of a watch.
bool worth_watching(const scene::Scene& scene, const SceneFacts& facts,
                    const motion::ResponseOptions& options, double kick_turns) {
  const bool annular =
      std::ranges::any_of(scene.contacts, [](const scene::Contact& c) { return contact::annular(c.wall); });
  return annular && options.floquet_proof && kick_turns <= TorusWatch::settled_after &&
         facts.same_every_turn && !facts.rotationally_symmetric;
}

/// Whether the window since the watch saw a torus shows neither period nor rest.
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
  const double kick_turns = pulses_end_s(cell.scene) * cell.scene.speed_rad_per_s / (2 * std::numbers::pi);
  TorusWatch torus(cell.scene, options, worth_watching(cell.scene, facts, options, kick_turns));
  motion::Record record(cell.scene, options);
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
    // A turn that failed counts, too: the reversal may be why it did.
    run.slip_reversed = run.slip_reversed || turn.slip_reversed;
    if (run.outcome == integrate::run::Outcome::ok && integrate::run::work(turn.effort) > most_work)
      run.outcome = integrate::run::Outcome::step_limit;
    if (run.outcome != integrate::run::Outcome::ok) {
      run.motion.motion_class = motion::MotionClass::failed;
      return run;
    }
    ++run.revolutions;
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
  const auto& map = observed(cell.scene);
  std::vector<Complex> displacement_m;
  double peak = 0;
  for (int k = 0; k < options.samples_per_revolution; ++k) {
    const double phase = 2 * std::numbers::pi * k / options.samples_per_revolution;
    const Eigen::Vector2d z = map * cell.quiet.displacement(phase);
    displacement_m.emplace_back(z.x(), z.y());
    peak = std::max(peak, z.norm());
  }
  // Nothing that turns with the shaft moves a casing that is not touched.
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
