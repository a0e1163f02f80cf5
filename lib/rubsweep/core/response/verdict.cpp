#include "rubsweep/core/response/verdict.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "rubsweep/core/integrate/run/impulses.hpp"
#include "rubsweep/core/integrate/run/state_scale.hpp"
#include "rubsweep/core/integrate/run/work_bound.hpp"
#include "rubsweep/core/response/proof/section_map.hpp"
#include "rubsweep/core/response/rotating/rotating_frame.hpp"
#include "rubsweep/core/response/spectrum/comb.hpp"

namespace rubsweep::response {
namespace {

/// Largest tolerance, a hundredth of `separation`, so that the solver's noise does not separate the states.
constexpr double largest_tolerance_of_an_exponent = 1e-7;

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

/// Measures the survival of the chaos of which `followed` is a part.
void ask_how_long_it_lasts(proof::SceneMap& map, const motion::ResponseOptions& options,
                           const Followed& followed, Verdict& verdict) {
  verdict.survival =
      survive([&map](std::span<double> section) { return map(section); }, [&map] { return map.touched(); },
              followed, {.window = options.window_revolutions, .max_order = options.max_order});
  if (verdict.survival->escapes > 0) verdict.motion.status = motion::MotionStatus::transient_chaos;
}

/// Sections of the last window, one per turn.
std::span<const double> sections_of(const motion::Record& record) {
  const motion::Window window = record.window(1);
  return window.section.subspan(static_cast<std::size_t>(window.states));
}

/// Measures a followed motion in its own last two windows.
void measure_again(const scene::Scene& scene, const SceneFacts& facts,
                   const integrate::run::SolverOptions& solver, const motion::ResponseOptions& options,
                   const Followed& followed, motion::Workspace& workspace, motion::Motion& motion) {
  const auto turns = 2 * static_cast<std::size_t>(options.window_revolutions);
  const auto from = followed.last_rows(turns + 1).first(followed.states);
  const auto record = recorded_run(integrate::run::scene_at(proof::after_the_kick(scene), from, 0), solver,
                                   options, static_cast<long>(turns), workspace);
  if (!record) {
    motion.motion_class = motion::MotionClass::unsettled;
    motion.status = motion::MotionStatus::step_limit;
    return;
  }
  const auto last = motion::classify_window(record->window(1), options, workspace.spectrum);
  motion.measures = last.measures;
  if (!may_be_aperiodic(last)) motion.motion_class = motion::MotionClass::unsettled;
  if (facts.rotationally_symmetric && motion.motion_class == motion::MotionClass::quasi_periodic)
    look_for_comb(*record, options, workspace, motion);
}

/// Makes turns until one ends without contact. A motion whose damping depends on approach speeds can be
/// followed from such a section.
bool goes_on_in_the_air(proof::SceneMap& map, std::vector<double>& section, int most_turns) {
  map.keep_memory();
  for (int turn = 0; turn < most_turns; ++turn) {
    if (!map(section)) return false;
    if (!map.touching_at_end()) return true;
  }
  return false;
}

void follow_on(const scene::Scene& scene, const SceneFacts& facts, integrate::run::SolverOptions solver,
               const motion::ResponseOptions& options, const motion::Record& record,
               std::span<const double> section, motion::Workspace& workspace,
               integrate::run::WorkBudget& budget, Verdict& verdict) {
  motion::Motion& motion = verdict.motion;
  solver.relative_tolerance = std::min(solver.relative_tolerance, largest_tolerance_of_an_exponent);
  proof::SceneMap map(scene, solver, workspace.modes, &budget);
  std::vector<double> start(section.begin(), section.end());
  if (map.remembers() && !goes_on_in_the_air(map, start, options.window_revolutions)) return;
  const Aperiodic found = classify_aperiodic(
      tangent_growth(map), [&map] { return map.touched(); }, std::move(start),
      static_cast<std::size_t>(options.max_revolutions), scene::observed(scene), options.window_revolutions,
      workspace.spectrum);
  motion.motion_class = found.motion_class;
  motion.exponent = found.exponent;
  if (budget.used_up()) motion.status = motion::MotionStatus::step_limit;
  if (found.left_chaos) motion.status = motion::MotionStatus::transient_chaos;
  if (found.returns_after.value_or(0) > options.max_order)
    motion.status = motion::MotionStatus::order_above_max;
  if (motion.motion_class != motion::MotionClass::unsettled && !belongs_to(found.motion, sections_of(record)))
    measure_again(scene, facts, solver, options, found.motion, workspace, motion);
  if (motion.motion_class == motion::MotionClass::chaotic)
    ask_how_long_it_lasts(map, options, found.motion, verdict);
}

}  // namespace

std::optional<motion::Record> recorded_run(const scene::Scene& scene,
                                           const integrate::run::SolverOptions& solver,
                                           const motion::ResponseOptions& options, long turns,
                                           motion::Workspace& workspace) {
  const long recorded = 2L * options.window_revolutions;
  motion::Wanted wanted{
      .turns = recorded, .samples_per_revolution = options.samples_per_revolution, .peaks = true};
  wanted.settling.most_turns = turns - recorded;
  wanted.settling.most_work = integrate::run::most_work_of_a_run(solver, scene.structure.coordinates());
  motion::Record record(scene, options);
  wanted.take = [&](const motion::RecordedTurn& turn) {
    if (turn.left == recorded) record.begin(turn.begin);
    record.add(turn.report);
  };
  if (!motion::record_settled(scene, solver, workspace.modes, wanted)) return std::nullopt;
  return record;
}

Checkpoints::Checkpoints(int window_revolutions, std::span<const double> start)
    : spacing_((window_revolutions + parts - 1) / parts) {
  for (Checkpoint& checkpoint : last_) checkpoint.section.assign(start.begin(), start.end());
}

void Checkpoints::pass(long revolutions, std::span<const double> section) {
  if (revolutions % spacing_ != 0) return;
  std::rotate(last_.begin(), last_.end() - 1, last_.end());
  last_[0].revolutions = revolutions;
  last_[0].section.assign(section.begin(), section.end());
}

const Checkpoints::Checkpoint& Checkpoints::before(long revolutions) const {
  const auto found =
      std::ranges::find_if(last_, [=](const Checkpoint& c) { return c.revolutions <= revolutions; });
  return found == last_.end() ? last_.back() : *found;
}

SceneFacts::SceneFacts(const scene::Scene& scene)
    : rotationally_symmetric(rotating::rotationally_symmetric(scene)),
      same_every_turn(integrate::run::same_every_turn(scene)) {}

bool may_be_aperiodic(const motion::WindowVerdict& verdict) {
  return verdict.motion_class == motion::MotionClass::unsettled && !verdict.period;
}

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
  if (const auto chaos = watch.chaos(); chaos && belongs_to(watch.motion(), sections_of(record))) {
    motion.motion_class = motion::MotionClass::chaotic;
    motion.exponent = chaos;
    proof::SceneMap map(scene, solver, workspace.modes, &budget);
    map.keep_memory();
    ask_how_long_it_lasts(map, options, watch.motion(), verdict);
  } else {
    follow_on(scene, facts, solver, options, record, section, workspace, budget, verdict);
  }
  return verdict;
}

}  // namespace rubsweep::response
