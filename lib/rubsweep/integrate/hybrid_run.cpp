#include "rubsweep/integrate/hybrid_run.hpp"

#include <algorithm>
#include <optional>

#include "rubsweep/integrate/adaptive/start_adaptive.hpp"
#include "rubsweep/integrate/exact/exact_run.hpp"
#include "rubsweep/integrate/run/state_scale.hpp"

namespace rubsweep::integrate {
namespace {

constexpr int longest_absence = 64;  ///< turns by the adaptive solver before closed forms are tried again

/// The scene as it stands at the start of revolution `revolution`, at `section`.
scene::Scene scene_at(scene::Scene scene, std::span<const double> section, long revolution) {
  run::set_initial_state(scene, section);
  scene.elapsed_revolutions += revolution;
  for (scene::Pulse& pulse : scene.pulses)
    pulse.elapsed_s += static_cast<double>(revolution) * scene.period_s();
  return scene;
}

/// Exact turns, and adaptive ones where there is no closed form.
template <int N>
class ExactCursor {
 public:
  ExactCursor(const scene::Scene& scene, const run::SolverOptions& options,
              std::shared_ptr<exact::MachineModes<N>> modes)
      : scene_(scene), options_(options), run_(scene, std::move(modes), options.max_steps_per_revolution) {}

  run::Outcome operator()(const run::TurnRequest& request, run::TurnReport& report) {
    if (!adaptive_) {
      switch (run_.advance(request, report)) {
        case exact::ExactEnding::ok:
          return finish(report, run::Outcome::ok);
        case exact::ExactEnding::step_limit:
          return finish(report, run::Outcome::step_limit);
        case exact::ExactEnding::non_finite:
          return finish(report, run::Outcome::non_finite);
        case exact::ExactEnding::beyond:
          leave();
      }
    }
    return advance_adaptively(request, report);
  }

  void restart(std::span<const double> section) {
    run_.restart(section);
    adaptive_ = nullptr;
    absence_ = 1;
  }

 private:
  void leave() {
    adaptive_ = adaptive::start_adaptive(scene_at(scene_, run_.section(), run_.revolution()), options_);
    absent_ = 0;
    adaptive_effort_ = {};
    absence_ = std::min(2 * absence_, longest_absence);
  }

  run::Outcome advance_adaptively(const run::TurnRequest& request, run::TurnReport& report) {
    const run::Outcome outcome = adaptive_(request, report);
    adaptive_effort_ = report.effort;
    ++adaptive_turns_;
    finish(report, outcome);
    if (outcome != run::Outcome::ok) return outcome;
    run_.resume(report.section);
    ++absent_;
    if (!report.touched || absent_ >= absence_) {
      if (!report.touched) absence_ = 1;
      past_ = sum(past_, adaptive_effort_);
      adaptive_effort_ = {};
      adaptive_ = nullptr;
    }
    return outcome;
  }

  static run::Effort sum(run::Effort a, const run::Effort& b) {
    a.rhs_calls += b.rhs_calls;
    a.steps += b.steps;
    a.refused += b.refused;
    a.switches += b.switches;
    a.implicit_steps += b.implicit_steps;
    a.adaptive_turns += b.adaptive_turns;
    return a;
  }

  run::Outcome finish(run::TurnReport& report, run::Outcome outcome) {
    report.effort = sum(sum(past_, adaptive_effort_), run_.effort());
    report.effort.adaptive_turns = adaptive_turns_;
    return outcome;
  }

  scene::Scene scene_;
  run::SolverOptions options_;
  exact::ExactRun<N> run_;
  run::Cursor adaptive_;  ///< empty while closed forms do
  int absence_ = 1, absent_ = 0;
  long adaptive_turns_ = 0;
  run::Effort past_, adaptive_effort_;
};

template <int N>
run::Run start(const scene::Scene& scene, const run::SolverOptions& options, exact::ModeCache& modes) {
  auto run = std::make_shared<ExactCursor<N>>(scene, options, modes.modes_of<N>(scene));
  return {[run](const run::TurnRequest& request, run::TurnReport& report) { return (*run)(request, report); },
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
