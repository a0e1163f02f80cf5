#include "rubsweep/integrate/exact.hpp"

#include <algorithm>
#include <optional>

#include "rubsweep/integrate/adaptive.hpp"
#include "rubsweep/integrate/exact_run.hpp"

namespace rubsweep::integrate {
namespace {

constexpr int longest_absence = 64;  ///< turns by the adaptive solver before closed forms are tried again

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

/// Exact turns, and adaptive ones where there is no closed form.
template <int N>
class ExactCursor {
 public:
  ExactCursor(const scene::Scene& scene, const SolverOptions& options, std::shared_ptr<ExactPlan<N>> plan)
      : scene_(scene), options_(options), run_(scene, std::move(plan), options.max_steps_per_revolution) {}

  Outcome operator()(Turn& turn) {
    if (!adaptive_) {
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
    return advance_adaptively(turn);
  }

  void restart(std::span<const double> section) {
    run_.restart(section);
    adaptive_ = nullptr;
    absence_ = 1;
  }

 private:
  void leave() {
    adaptive_ = start_adaptive(scene_at(scene_, run_.section(), run_.revolution()), options_);
    absent_ = 0;
    adaptive_effort_ = {};
    absence_ = std::min(2 * absence_, longest_absence);
  }

  Outcome advance_adaptively(Turn& turn) {
    const Outcome outcome = adaptive_(turn);
    adaptive_effort_ = turn.effort;
    ++adaptive_turns_;
    report(turn, outcome);
    if (outcome != Outcome::ok) return outcome;
    run_.resume(turn.section);
    ++absent_;
    if (!turn.touched || absent_ >= absence_) {
      if (!turn.touched) absence_ = 1;
      past_ = sum(past_, adaptive_effort_);
      adaptive_effort_ = {};
      adaptive_ = nullptr;
    }
    return outcome;
  }

  static Effort sum(Effort a, const Effort& b) {
    a.rhs_calls += b.rhs_calls;
    a.steps += b.steps;
    a.refused += b.refused;
    a.switches += b.switches;
    a.implicit_steps += b.implicit_steps;
    a.adaptive_turns += b.adaptive_turns;
    return a;
  }

  Outcome report(Turn& turn, Outcome outcome) {
    turn.effort = sum(sum(past_, adaptive_effort_), run_.effort());
    turn.effort.adaptive_turns = adaptive_turns_;
    return outcome;
  }

  scene::Scene scene_;
  SolverOptions options_;
  ExactRun<N> run_;
  Cursor adaptive_;  ///< empty while closed forms do
  int absence_ = 1, absent_ = 0;
  long adaptive_turns_ = 0;
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
