#include "rubsweep/core/integrate/hybrid_run.hpp"

#include <algorithm>
#include <numbers>

#include "rubsweep/core/integrate/adaptive/start_adaptive.hpp"
#include "rubsweep/core/integrate/exact/exact_run.hpp"
#include "rubsweep/core/integrate/exact/modes/machine_modes.hpp"
#include "rubsweep/core/integrate/exact/sticking_stretch.hpp"
#include "rubsweep/core/integrate/run/coordinates.hpp"
#include "rubsweep/core/integrate/run/pulse_times.hpp"
#include "rubsweep/core/integrate/run/state_scale.hpp"
#include "rubsweep/core/integrate/run/work_bound.hpp"
#include "rubsweep/core/integrate/stiff_turns.hpp"
#include "rubsweep/core/integrate/taylor/taylor_run.hpp"
#include "rubsweep/core/numerics/flush_subnormals.hpp"
#include "rubsweep/core/numerics/full_turn.hpp"

namespace rubsweep::integrate {
namespace {

constexpr int longest_absence = 64;  ///< turns by other methods before closed forms are tried again
/// Latest phase at which closed forms take over again; after it too little time is left in the turn.
constexpr double last_join = 2 * std::numbers::pi - 1e-9;
/// Distance (rad) from the end of the turn where a sticking stretch ends; a piece completes the turn.
constexpr double before_the_end = 1e-6;
/// Largest number of pieces before the next search for a sticking stretch after one without success.
constexpr int longest_wait = 64;
/// Number of successive sticking pieces at one place of an annular stop after which a mode for this place
/// saves time.
constexpr int pieces_worth_a_mode = 16;

/// Largest work of a turn made by several methods together.
double most_work_of_a_turn(const run::SolverOptions& options) {
  return run::work_of_an_expansion * static_cast<double>(run::most_pieces_of_a_turn(options));
}

/// Whether the method may change during a turn: between flat stops, with Taylor series.
bool may_be_in_pieces(const scene::Scene& scene, const run::SolverOptions& options) {
  return scene.impulses.empty() && options.stepper == run::Stepper::automatic &&
         options.contact == run::ContactHandling::located &&
         std::ranges::all_of(scene.contacts, [](const scene::Contact& c) { return contact::linear(c.wall); });
}

/// Whether dry friction may hold the rotor at one place of an annular stop (no surface speed).
bool may_stick_in_a_ring(const scene::Scene& scene) {
  return scene.impulses.empty() && std::ranges::any_of(scene.contacts, [](const scene::Contact& c) {
           return contact::annular(c.wall) && c.surface_speed_m_per_s == 0 &&
                  contact::holding_coefficient(c.friction) != 0;
         });
}

/// Turns made by the exact solver, by Taylor pieces where there is no closed form, or by a stepper if one was
/// chosen by name.
template <int N>
class HybridRun {
 public:
  HybridRun(const scene::Scene& scene, const run::SolverOptions& options,
            std::shared_ptr<exact::modes::MachineModes<N>> modes)
      : scene_(scene),
        options_(options),
        run_(scene, std::move(modes), options.max_steps_per_revolution),
        in_pieces_(may_be_in_pieces(scene, options)),
        sticks_in_rings_(may_stick_in_a_ring(scene)),
        stiff_(scene_, options),
        end_of_pulses_rad_(run::pulses_end_s(scene) * scene.speed_rad_per_s) {}

  run::Outcome operator()(const run::TurnRequest& request, run::TurnReport& report) {
    if (stiff_.due()) {
      const bool made = stiff_.advance(run_.section(), run_.revolution(), request, report);
      if (made) return made_stiffly(report);
    }
    const long pieces = pieces_so_far(), changes = switches_;
    const run::Outcome outcome = advance_explicitly(request, report);
    stiff_.look(pieces_so_far() - pieces, switches_ - changes);
    return outcome;
  }

  void restart(std::span<const double> section) {
    run_.restart(section);
    come_back();
    absence_ = 1;
    stiff_.restart();
  }

 private:
  using TaylorRun = taylor::TaylorRun<N>;

  /// The method that makes the next turn.
  enum class Maker { closed_forms, series, stepper };

  long pieces_so_far() const { return taylor_ ? taylor_->effort().steps : 0; }

  run::Outcome made_stiffly(run::TurnReport& report) {
    come_back();
    run_.resume(report.section);
    ++adaptive_turns_;
    return finish(report, run::Outcome::ok);
  }

  /// Makes a turn by closed forms where they apply, otherwise by the method that replaces them.
  run::Outcome advance_explicitly(const run::TurnRequest& request, run::TurnReport& report) {
    if (maker_ == Maker::closed_forms) {
      const run::Outcome outcome = run_.advance(request, report);
      const bool unsaturated = outcome == run::Outcome::unsaturated;
      if (unsaturated && in_pieces_) return go_on_in_pieces(request, report);
      if (!unsaturated && outcome != run::Outcome::no_closed_form) return finish(report, outcome);
      leave();
    }
    return maker_ == Maker::stepper ? advance_adaptively(request, report)
                                    : advance_by_series(request, report);
  }

  /// Makes a turn in which friction leaves saturation: Taylor pieces until friction is saturated again, then
  /// closed forms. The run is at the start of the first of these pieces.
  run::Outcome go_on_in_pieces(const run::TurnRequest& request, run::TurnReport& report) {
    if (!taylor_) taylor_ = std::make_unique<TaylorRun>(scene_, options_);
    pieces_to_wait_ = wait_ = 0;
    const double before = work_so_far();
    for (;;) {
      if (work_so_far() - before > most_work_of_a_turn(options_))
        return finish(report, run::Outcome::step_limit);
      const auto& place = run_.handover();
      taylor_->join(request, run_.revolution(), place.phase_rad, place.state, place.modes,
                    place.tangent_vectors);
      const run::Outcome piece = make_piece(request, report, before);
      if (piece != run::Outcome::ok) return finish(report, piece);
      if (taylor_->at_end_of_turn()) {
        taylor_->finish(report);
        run_.resume(report.section);
        ++taylor_turns_;
        return finish(report, run::Outcome::ok);
      }
      const run::Outcome rest = run_.go_to_end(taylor_->tangents(), report);
      if (rest == run::Outcome::no_closed_form) {
        leave();
        return advance_by_series(request, report);
      }
      if (rest == run::Outcome::ok) ++taylor_turns_;
      if (rest != run::Outcome::unsaturated) return finish(report, rest);
    }
  }

  /// Makes pieces until closed forms take over or the turn ends; `before`: work before the turn.
  run::Outcome make_piece(const run::TurnRequest& request, run::TurnReport& report, double before) {
    for (;;) {
      const run::Outcome ending = taylor_->go_on(report);
      if (ending != run::Outcome::ok || taylor_->at_end_of_turn()) return ending;
      if (taylor_->sticks() && lasts() && stick(request, report) &&
          work_so_far() - before > most_work_of_a_turn(options_))
        return run::Outcome::step_limit;
      const bool may_join = in_pieces_ && !taylor_->sticks() && taylor_->phase_rad() < last_join;
      if (may_join && run_.join(taylor_->phase_rad(), taylor_->section(), taylor_->modes(), report))
        return ending;
    }
  }

  /// Whether a contact has stuck so long that a mode for its place in an annular stop saves time.
  bool lasts() {
    if (!sticks_in_rings_) return true;
    if (std::exchange(switches_of_stuck_, taylor_->effort().switches) != taylor_->effort().switches)
      stuck_pieces_ = 0;
    return ++stuck_pieces_ > pieces_worth_a_mode;
  }

  /// Uses closed forms as long as friction holds the touching contacts. False, with nothing changed, where
  /// there is no such stretch, or where many stretches were so short that pieces are made for a while
  /// instead.
  bool stick(const run::TurnRequest& request, run::TurnReport& report) {
    const double phase = taylor_->phase_rad();
    if (static_cast<double>(run_.revolution()) * numerics::full_turn + phase < end_of_pulses_rad_)
      return false;
    if (pieces_to_wait_ > 0) return --pieces_to_wait_, false;
    if (!sticking_) sticking_ = std::make_unique<exact::StickingStretch>(scene_);
    held_.phase_rad = phase;
    held_.state = taylor_->section();
    held_.tangent_vectors = taylor_->tangents();
    if (!sticking_->go_on(request, taylor_->modes(), taylor_->slips(), numerics::full_turn - before_the_end,
                          options_.max_steps_per_revolution, held_, report)) {
      pieces_to_wait_ = wait_ = std::clamp(2 * wait_, 1, longest_wait);
      return false;
    }
    wait_ = 0;
    taylor_->join(request, run_.revolution(), held_.phase_rad, held_.state, taylor_->modes(),
                  held_.tangent_vectors);
    return true;
  }

  /// Work of this run without that of its stepper.
  double work_so_far() const {
    run::Effort effort = run_.effort();
    if (taylor_) effort = effort + taylor_->effort();
    return run::work(effort) +
           run::work_of_a_step * (sticking_ ? static_cast<double>(sticking_->steps()) : 0);
  }

  /// Uses Taylor pieces or a stepper instead of closed forms for a number of turns.
  void leave() {
    absent_ = 0;
    absence_ = std::min(2 * absence_, longest_absence);
    const bool by_name =
        options_.stepper != run::Stepper::automatic || options_.contact != run::ContactHandling::located;
    maker_ = by_name ? Maker::stepper : Maker::series;
    if (by_name) return start_stepper();
    if (!taylor_) taylor_ = std::make_unique<TaylorRun>(scene_, options_);
    run_.put_section(section_);
    taylor_->resume(section_, run_.revolution());
  }

  void start_stepper() {
    adaptive_ = adaptive::start_adaptive(run::scene_at(scene_, run_.section(), run_.revolution()), options_);
    adaptive_effort_ = {};
  }

  run::Outcome advance_by_series(const run::TurnRequest& request, run::TurnReport& report) {
    const run::Outcome outcome =
        sticks_in_rings_ ? advance_beside_rings(request, report) : taylor_->advance(request, report);
    if (outcome != run::Outcome::ok) return finish(report, outcome);
    ++taylor_turns_;
    finish(report, run::Outcome::ok);
    return made_away(report);
  }

  /// Makes a turn by Taylor pieces, and by closed forms where the rotor sticks.
  run::Outcome advance_beside_rings(const run::TurnRequest& request, run::TurnReport& report) {
    taylor_->begin(request, report);
    pieces_to_wait_ = wait_ = 0;
    const run::Outcome outcome = make_piece(request, report, work_so_far());
    if (outcome == run::Outcome::ok) taylor_->finish(report);
    return outcome;
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
    past_ = past_ + adaptive_effort_;
    adaptive_effort_ = {};
    adaptive_ = nullptr;
    maker_ = Maker::closed_forms;
  }

  run::Outcome finish(run::TurnReport& report, run::Outcome outcome) {
    report.effort = past_ + adaptive_effort_ + stiff_.effort() + run_.effort();
    if (taylor_) report.effort = report.effort + taylor_->effort();
    if (sticking_) report.effort.steps += sticking_->steps();
    report.effort.taylor_turns = taylor_turns_;
    report.effort.adaptive_turns = adaptive_turns_;
    switches_ = report.effort.switches;
    return outcome;
  }

  scene::Scene scene_;
  run::SolverOptions options_;
  exact::ExactRun<N> run_;
  bool in_pieces_ = false;        ///< true: turns whose friction leaves saturation are made in pieces
  bool sticks_in_rings_ = false;  ///< result of may_stick_in_a_ring
  long switches_of_stuck_ = 0;    ///< switches of pieces at the latest check for sticking
  int stuck_pieces_ = 0;          ///< number of pieces since the last switch
  StiffTurns stiff_;
  std::unique_ptr<TaylorRun> taylor_;                 ///< made when first needed
  std::unique_ptr<exact::StickingStretch> sticking_;  ///< made when first needed
  exact::StickingStretch::StretchState held_;
  double end_of_pulses_rad_ = 0;       ///< counted from the start of revolution 0
  int pieces_to_wait_ = 0, wait_ = 0;  ///< pieces until the next search for a sticking stretch
  run::Cursor adaptive_;               ///< empty while no stepper is in use
  Maker maker_ = Maker::closed_forms;
  std::vector<double> section_;  ///< state at which the run left closed forms
  int absence_ = 1, absent_ = 0;
  long taylor_turns_ = 0, adaptive_turns_ = 0, switches_ = 0;
  run::Effort past_, adaptive_effort_;
};

}  // namespace

run::Run start_hybrid(const scene::Scene& scene, const run::SolverOptions& options,
                      exact::modes::ModeCache& modes) {
  return run::with_coordinates(scene.structure.coordinates(), [&](auto n) -> run::Run {
    auto run = std::make_shared<HybridRun<n()>>(scene, options, modes.modes_of<n()>(scene));
    return {[run](const run::TurnRequest& request, run::TurnReport& report) {
              const numerics::FlushSubnormals flush;
              return (*run)(request, report);
            },
            [run](std::span<const double> section) { run->restart(section); }};
  });
}

}  // namespace rubsweep::integrate
