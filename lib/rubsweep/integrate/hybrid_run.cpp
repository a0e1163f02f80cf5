#include "rubsweep/integrate/hybrid_run.hpp"

#include <algorithm>
#include <optional>

#include "rubsweep/integrate/adaptive/start_adaptive.hpp"
#include "rubsweep/integrate/exact/exact_run.hpp"
#include "rubsweep/integrate/run/coordinates.hpp"
#include "rubsweep/integrate/run/state_scale.hpp"
#include "rubsweep/integrate/taylor/taylor_run.hpp"

namespace rubsweep::integrate {
namespace {

constexpr int longest_absence = 64;  ///< turns by other means before closed forms are tried again

/// The scene as it stands at the start of revolution `revolution`, at `section`.
scene::Scene scene_at(scene::Scene scene, std::span<const double> section, long revolution) {
  run::set_initial_state(scene, section);
  scene.elapsed_revolutions += revolution;
  for (scene::Pulse& pulse : scene.pulses)
    pulse.elapsed_s += static_cast<double>(revolution) * scene.period_s();
  return scene;
}

/// Exact turns; Taylor pieces where there is no closed form; a stepper's where friction is stiff, or where
/// one was asked for by name.
template <int N>
class HybridRun {
 public:
  HybridRun(const scene::Scene& scene, const run::SolverOptions& options,
            std::shared_ptr<exact::MachineModes<N>> modes)
      : scene_(scene), options_(options), run_(scene, std::move(modes), options.max_steps_per_revolution) {}

  run::Outcome operator()(const run::TurnRequest& request, run::TurnReport& report) {
    if (!away_) {
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
    return adaptive_ ? advance_adaptively(request, report) : advance_by_series(request, report);
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
    run_.put_section(section_);
    taylor_->resume(section_, run_.revolution());
  }

  void start_stepper() {
    adaptive_ = adaptive::start_adaptive(scene_at(scene_, run_.section(), run_.revolution()), options_);
    adaptive_effort_ = {};
  }

  run::Outcome advance_by_series(const run::TurnRequest& request, run::TurnReport& report) {
    switch (taylor_->advance(request, report)) {
      case taylor::TaylorEnding::ok:
        break;
      case taylor::TaylorEnding::stiff:
        start_stepper();
        return advance_adaptively(request, report);
      case taylor::TaylorEnding::step_limit:
        return finish(report, run::Outcome::step_limit);
      case taylor::TaylorEnding::non_finite:
        return finish(report, run::Outcome::non_finite);
      case taylor::TaylorEnding::stick_undetermined:
        return finish(report, run::Outcome::stick_undetermined);
    }
    ++taylor_turns_;
    finish(report, run::Outcome::ok);
    return made_away(report);
  }

  run::Outcome advance_adaptively(const run::TurnRequest& request, run::TurnReport& report) {
    const run::Outcome outcome = adaptive_(request, report);
    adaptive_effort_ = report.effort;
    ++adaptive_turns_;
    finish(report, outcome);
    return outcome == run::Outcome::ok ? made_away(report) : outcome;
  }

  run::Outcome made_away(const run::TurnReport& report) {
    run_.resume(report.section);
    ++absent_;
    if (!report.touched || absent_ >= absence_) {
      if (!report.touched) absence_ = 1;
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

  run::Outcome finish(run::TurnReport& report, run::Outcome outcome) {
    report.effort = sum(sum(past_, adaptive_effort_), run_.effort());
    if (taylor_) report.effort = sum(report.effort, taylor_->effort());
    report.effort.taylor_turns = taylor_turns_;
    report.effort.adaptive_turns = adaptive_turns_;
    return outcome;
  }

  scene::Scene scene_;
  run::SolverOptions options_;
  exact::ExactRun<N> run_;
  std::unique_ptr<TaylorRun> taylor_;  ///< made when first needed
  run::Cursor adaptive_;               ///< empty while no stepper is at work
  bool away_ = false;                  ///< from closed forms
  std::vector<double> section_;        ///< where the run left them
  int absence_ = 1, absent_ = 0;
  long taylor_turns_ = 0, adaptive_turns_ = 0;
  run::Effort past_, adaptive_effort_;
};

}  // namespace

run::Run start_hybrid(const scene::Scene& scene, const run::SolverOptions& options, exact::ModeCache& modes) {
  return run::with_coordinates(scene.structure.coordinates(), [&](auto n) -> run::Run {
    auto run = std::make_shared<HybridRun<n()>>(scene, options, modes.modes_of<n()>(scene));
    return {
        [run](const run::TurnRequest& request, run::TurnReport& report) { return (*run)(request, report); },
        [run](std::span<const double> section) { run->restart(section); }};
  });
}

}  // namespace rubsweep::integrate
