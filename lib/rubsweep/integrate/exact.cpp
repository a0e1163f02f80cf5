#include "rubsweep/integrate/exact.hpp"

#include <algorithm>
#include <optional>

#include "rubsweep/integrate/adaptive.hpp"
#include "rubsweep/integrate/exact_run.hpp"
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

/// Exact turns; Taylor pieces where there is no closed form; a stepper's where friction is stiff, or where one
/// was asked for by name.
template <int N>
class ExactCursor {
 public:
  ExactCursor(const scene::Scene& scene, const SolverOptions& options, std::shared_ptr<ExactPlan<N>> plan)
      : scene_(scene), options_(options), run_(scene, std::move(plan), options.max_steps_per_revolution) {}

  Outcome operator()(Turn& turn) {
    if (!away_) {
      switch (run_.advance(turn)) {
        case ExactEnding::ok:
          return report(turn, Outcome::ok);
        case ExactEnding::step_limit:
          return report(turn, Outcome::step_limit);
        case ExactEnding::non_finite:
          return report(turn, Outcome::non_finite);
        case ExactEnding::beyond:
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
    if (options_.stepper != Stepper::automatic || options_.contact != ContactHandling::located)
      return start_stepper();
    if (!taylor_) taylor_ = std::make_unique<TaylorRun>(scene_, options_);
    taylor_->resume(run_.section(), run_.revolution());
  }

  void start_stepper() {
    adaptive_ = start_adaptive(scene_at(scene_, run_.section(), run_.revolution()), options_);
    adaptive_effort_ = {};
  }

  Outcome advance_by_series(Turn& turn) {
    switch (taylor_->advance(turn)) {
      case taylor::TaylorEnding::ok:
        break;
      case taylor::TaylorEnding::stiff:
        start_stepper();
        return advance_adaptively(turn);
      case taylor::TaylorEnding::step_limit:
        return report(turn, Outcome::step_limit);
      case taylor::TaylorEnding::non_finite:
        return report(turn, Outcome::non_finite);
    }
    ++taylor_turns_;
    report(turn, Outcome::ok);
    return made_away(turn);
  }

  Outcome advance_adaptively(Turn& turn) {
    const Outcome outcome = adaptive_(turn);
    adaptive_effort_ = turn.effort;
    ++adaptive_turns_;
    report(turn, outcome);
    return outcome == Outcome::ok ? made_away(turn) : outcome;
  }

  Outcome made_away(const Turn& turn) {
    run_.resume(turn.section);
    ++absent_;
    if (!turn.touched || absent_ >= absence_) {
      if (!turn.touched) absence_ = 1;
      come_back();
    }
    return Outcome::ok;
  }

  void come_back() {
    past_ = sum(past_, adaptive_effort_);
    adaptive_effort_ = {};
    adaptive_ = nullptr;
    away_ = false;
  }

  static Effort sum(Effort a, const Effort& b) {
    a.rhs_calls += b.rhs_calls;
    a.steps += b.steps;
    a.refused += b.refused;
    a.switches += b.switches;
    a.implicit_steps += b.implicit_steps;
    return a;
  }

  Outcome report(Turn& turn, Outcome outcome) {
    turn.effort = sum(sum(past_, adaptive_effort_), run_.effort());
    if (taylor_) turn.effort = sum(turn.effort, taylor_->effort());
    turn.effort.taylor_turns = taylor_turns_;
    turn.effort.adaptive_turns = adaptive_turns_;
    return outcome;
  }

  scene::Scene scene_;
  SolverOptions options_;
  ExactRun<N> run_;
  std::unique_ptr<TaylorRun> taylor_;  ///< made when first needed
  Cursor adaptive_;                    ///< empty while no stepper is at work
  bool away_ = false;                  ///< from closed forms
  int absence_ = 1, absent_ = 0;
  long taylor_turns_ = 0, adaptive_turns_ = 0;
  Effort past_, adaptive_effort_;
};

template <int N>
Run start(const scene::Scene& scene, const SolverOptions& options, ExactPlans& plans) {
  auto run = std::make_shared<ExactCursor<N>>(scene, options, plans.plan_for<N>(scene));
  return {[run](Turn& turn) { return (*run)(turn); },
          [run](std::span<const double> section) { run->restart(section); }};
}

}  // namespace

Run start_exact(const scene::Scene& scene, const SolverOptions& options, ExactPlans& plans) {
  switch (scene.structure.coordinates()) {
    case 2:
      return start<2>(scene, options, plans);
    case 4:
      return start<4>(scene, options, plans);
    case 6:
      return start<6>(scene, options, plans);
    default:
      return start<Eigen::Dynamic>(scene, options, plans);
  }
}

bool exact_applies(const scene::Scene& scene) {
  return scene.contacts.size() <= most_exact_contacts &&
         scene.structure.coordinates() <= most_exact_coordinates;
}

}  // namespace rubsweep::integrate
