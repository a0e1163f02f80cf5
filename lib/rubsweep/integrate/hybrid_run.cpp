#include "rubsweep/integrate/hybrid_run.hpp"

#include <algorithm>
#include <optional>

#include "rubsweep/integrate/adaptive/start_adaptive.hpp"
#include "rubsweep/integrate/exact/exact_run.hpp"
#include "rubsweep/integrate/taylor/taylor_run.hpp"

namespace rubsweep::integrate {
namespace {

constexpr int longest_absence = 64;  ///< turns by other means before closed forms are tried again

/// The scene as it stands at the start of revolution `revolution`, at `section`.
scene::Scene scene_at(scene::Scene scene, std::span<const double> section, long revolution) {
  const Eigen::Index n = scene.structure.coordinates();
  const Eigen::Map<const Eigen::VectorXd> state(section.data(), 2 * n);
  scene.displacement_m = scene.length_scale_m * state.head(n);
  scene.velocity_m_per_s = scene.length_scale_m * scene.speed_rad_per_s * state.tail(n);
  scene.elapsed_revolutions += revolution;
  if (scene.pulse) scene.pulse->elapsed_s += static_cast<double>(revolution) * scene.period_s();
  return scene;
}

/// Exact turns; Taylor pieces where there is no closed form; a stepper's where friction is stiff, or where
/// one was asked for by name.
template <int N>
class ExactCursor {
 public:
  ExactCursor(const scene::Scene& scene, const run::SolverOptions& options,
              std::shared_ptr<exact::MachineModes<N>> modes)
      : scene_(scene), options_(options), run_(scene, std::move(modes), options.max_steps_per_revolution) {}

  run::Outcome operator()(run::Turn& turn) {
    if (!away_) {
      switch (run_.advance(turn)) {
        case exact::ExactEnding::ok:
          return report(turn, run::Outcome::ok);
        case exact::ExactEnding::step_limit:
          return report(turn, run::Outcome::step_limit);
        case exact::ExactEnding::non_finite:
          return report(turn, run::Outcome::non_finite);
        case exact::ExactEnding::beyond:
          leave();
      }
    }
    return adaptive_ ? advance_adaptively(turn) : advance_by_series(turn);
  }

  void restart(std::span<const double> section) {
    run_.restart(section);
    come_back();
    absence_ = 1;
  }

 private:
  using TaylorRun = taylor::TaylorRun<N>;

  void leave() {
    away_ = true;
    absent_ = 0;
    absence_ = std::min(2 * absence_, longest_absence);
    if (options_.stepper != run::Stepper::automatic || options_.contact != run::ContactHandling::located)
      return start_stepper();
    if (!taylor_) taylor_ = std::make_unique<TaylorRun>(scene_, options_);
    taylor_->resume(run_.section(), run_.revolution());
  }

  void start_stepper() {
    adaptive_ = adaptive::start_adaptive(scene_at(scene_, run_.section(), run_.revolution()), options_);
    adaptive_effort_ = {};
  }

  run::Outcome advance_by_series(run::Turn& turn) {
    switch (taylor_->advance(turn)) {
      case taylor::TaylorEnding::ok:
        break;
      case taylor::TaylorEnding::stiff:
        start_stepper();
        return advance_adaptively(turn);
      case taylor::TaylorEnding::step_limit:
        return report(turn, run::Outcome::step_limit);
      case taylor::TaylorEnding::non_finite:
        return report(turn, run::Outcome::non_finite);
    }
    ++taylor_turns_;
    report(turn, run::Outcome::ok);
    return made_away(turn);
  }

  run::Outcome advance_adaptively(run::Turn& turn) {
    const run::Outcome outcome = adaptive_(turn);
    adaptive_effort_ = turn.effort;
    ++adaptive_turns_;
    report(turn, outcome);
    return outcome == run::Outcome::ok ? made_away(turn) : outcome;
  }

  run::Outcome made_away(const run::Turn& turn) {
    run_.resume(turn.section);
    ++absent_;
    if (!turn.touched || absent_ >= absence_) {
      if (!turn.touched) absence_ = 1;
      come_back();
    }
    return run::Outcome::ok;
  }

  void come_back() {
    past_ = sum(past_, adaptive_effort_);
    adaptive_effort_ = {};
    adaptive_ = nullptr;
    away_ = false;
  }

  static run::Effort sum(run::Effort a, const run::Effort& b) {
    a.rhs_calls += b.rhs_calls;
    a.steps += b.steps;
    a.refused += b.refused;
    a.switches += b.switches;
    a.implicit_steps += b.implicit_steps;
    return a;
  }

  run::Outcome report(run::Turn& turn, run::Outcome outcome) {
    turn.effort = sum(sum(past_, adaptive_effort_), run_.effort());
    if (taylor_) turn.effort = sum(turn.effort, taylor_->effort());
    turn.effort.taylor_turns = taylor_turns_;
    turn.effort.adaptive_turns = adaptive_turns_;
    return outcome;
  }

  scene::Scene scene_;
  run::SolverOptions options_;
  exact::ExactRun<N> run_;
  std::unique_ptr<TaylorRun> taylor_;  ///< made when first needed
  run::Cursor adaptive_;               ///< empty while no stepper is at work
  bool away_ = false;                  ///< from closed forms
  int absence_ = 1, absent_ = 0;
  long taylor_turns_ = 0, adaptive_turns_ = 0;
  run::Effort past_, adaptive_effort_;
};

template <int N>
run::Run start(const scene::Scene& scene, const run::SolverOptions& options, exact::ModeCache& modes) {
  auto run = std::make_shared<ExactCursor<N>>(scene, options, modes.modes_of<N>(scene));
  return {[run](run::Turn& turn) { return (*run)(turn); },
          [run](std::span<const double> section) { run->restart(section); }};
}

}  // namespace

run::Run start_hybrid(const scene::Scene& scene, const run::SolverOptions& options, exact::ModeCache& modes) {
  switch (scene.structure.coordinates()) {
    case 2:
      return start<2>(scene, options, modes);
    case 4:
      return start<4>(scene, options, modes);
    case 6:
      return start<6>(scene, options, modes);
    default:
      return start<Eigen::Dynamic>(scene, options, modes);
  }
}

}  // namespace rubsweep::integrate
