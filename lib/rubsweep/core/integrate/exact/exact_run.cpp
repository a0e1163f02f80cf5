#include "rubsweep/core/integrate/exact/exact_run.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "rubsweep/core/integrate/exact/joint_switch.hpp"
#include "rubsweep/core/integrate/exact/modes/joint_mode.hpp"
#include "rubsweep/core/integrate/exact/step_choice.hpp"
#include "rubsweep/core/numerics/exponential_series.hpp"

namespace rubsweep::integrate::exact {
namespace {

using contact::Mode;

constexpr double shortest_step = 1e-13;  ///< share of a turn: smallest step, used to pass a graze
constexpr double same_instant = 1e-13;   ///< share of a turn: crossings closer than this are simultaneous
/// Shortest step towards an annular stop, as a share of a turn; below it the stop counts as touched.
constexpr double shortest_to_annular = 1e-7;
/// Largest number of steps in a turn. More steps show that the bounds are too wide for the motion, as with
/// friction so strong that closed forms are small differences of large numbers. The adaptive solver then
/// makes the turn.
constexpr long most_steps = 100'000;
/// Shortest certain stretch of saturated friction, as a share of a mode's longest step, for a return from
/// another solver: longer than the stretch that ends an exact piece, lest the two solvers alternate.
constexpr double stretch_to_join = 16 * SlipWatch<2>::shortest_stretch;

}  // namespace

template <int N>
ExactRun<N>::ExactRun(const scene::Scene& scene, std::shared_ptr<modes::MachineModes<N>> modes,
                      long max_steps, bool flights_only)
    : motion_(scene, modes),
      scale_(run::state_scale(scene)),
      clock_(run::TurnClock::in_seconds(scene, scale_)),
      slip_(scene, modes->friction()),
      watch_(*modes, scene, clock_.period()),
      max_steps_(max_steps),
      flights_only_(flights_only) {
  const std::vector<double> start = scale_.in_seconds().state(scene.displacement_m, scene.velocity_m_per_s);
  turn_start_ = Eigen::Map<const Eigen::VectorXd>(start.data(), static_cast<Eigen::Index>(start.size()));
}

template <int N>
std::vector<double> ExactRun<N>::section() const {
  std::vector<double> section;
  put_section(section);
  return section;
}

template <int N>
void ExactRun<N>::resume(std::span<const double> section) {
  turn_start_ = scale_.state_in_seconds<State>(section);
  ++book_.revolution;
  goes_on_ = false;
}

template <int N>
run::Outcome ExactRun<N>::advance(const run::TurnRequest& request, run::TurnReport& report) {
  if (!begin_turn(request, report)) return without_closed_form();
  return run_to_end(report);
}

template <int N>
run::Outcome ExactRun<N>::run_to_end(run::TurnReport& report) {
  book_.limit_steps(std::min(max_steps_, most_steps));
  run::Outcome ending = run::Outcome::ok;
  while (ending == run::Outcome::ok && !clock_.turn_is_over()) {
    if (book_.may_step()) {
      ending = go_on(report);
    } else if (max_steps_ <= most_steps) {
      ending = run::Outcome::step_limit;
    } else if (flights_only_) {
      hand_over(motion_.physical(), std::nullopt);
      ending = run::Outcome::unsaturated;
    } else {
      ending = run::Outcome::no_closed_form;
    }
  }
  if (ending == run::Outcome::ok) ending = end_turn(report);
  report.effort = book_.effort;
  return ending;
}

template <int N>
const typename ExactRun<N>::Handover& ExactRun<N>::handover() {
  handover_.phase_rad = clock_.phase_rad();
  scale_.put_section(here_, handover_.state);
  handover_.modes = motion_.mode().modes;
  handover_.tangent_vectors.resize(here_.size(), tangents_);
  motion_.put_tangents(handover_.tangent_vectors);
  return handover_;
}

template <int N>
bool ExactRun<N>::join(double phase_rad, std::span<const double> state, const std::vector<Mode>& modes,
                       const run::TurnReport& report) {
  const State physical = scale_.state_in_seconds<State>(state);
  const auto saturated = slip_.saturated_mode(motion_.machine(), modes::joint_mode_of(modes), physical);
  if (!saturated) return false;
  clock_.go_to_phase(phase_rad);
  clock_.change_pulses();
  motion_.carry_no_tangents();
  motion_.set_phases(phase_rad, clock_.pulses(), clock_.time());
  if (!motion_.enter(*saturated, physical) || !slip_.begin(motion_, physical, stretch_to_join)) return false;
  unsaturated_ = false;
  book_.note_progress(true);
  watch_.resume(report);
  watch_.begin_motion(motion_);
  return true;
}

template <int N>
run::Outcome ExactRun<N>::go_to_end(const Eigen::MatrixXd& tangent_vectors, run::TurnReport& report) {
  tangents_ = tangent_vectors.cols();
  motion_.carry_tangents(tangent_vectors);
  return run_to_end(report);
}

template <int N>
bool ExactRun<N>::begin_elsewhere(const run::TurnRequest& request, run::TurnReport& report) {
  report.clear();
  watch_.begin_turn(request, report, turn_start_.size());
  book_.begin_turn(request);
  motion_.carry_no_tangents();
  unsaturated_ = false;
  tangents_ = request.tangent_vectors.cols();
  return clock_.begin_turn(book_.revolution);
}

template <int N>
bool ExactRun<N>::begin_turn(const run::TurnRequest& request, run::TurnReport& report) {
  const bool pulses_changed = begin_elsewhere(request, report);
  if (!start_motion(pulses_changed)) return false;
  motion_.carry_tangents(request.tangent_vectors);
  if (!begin_motion(turn_start_)) return false;
  return !clock_.impulse_is_due() || apply_impulses(report);
}

/// At the start of a turn only the phase restarts, at exactly zero; the motion continues.
template <int N>
bool ExactRun<N>::start_motion(bool pulses_changed) {
  const bool stands = std::exchange(goes_on_, false);
  motion_.set_phases(0, clock_.pulses(), 0);
  if (!stands) return enter_by_state(turn_start_);
  return !pulses_changed || motion_.enter(motion_.joint(), turn_start_);
}

template <int N>
bool ExactRun<N>::enter_by_state(const State& physical) {
  if (!motion_.enter(0, physical)) return false;
  const std::size_t modes =
      modes::joint_mode_of(motion_.machine().system().contacts, physical, motion_.rate_of(physical));
  if (modes != 0 && flights_only_) return hand_over(physical, std::nullopt);
  return modes == 0 || motion_.enter(slip_.with_ways(motion_.machine(), modes, physical), physical);
}

template <int N>
run::Outcome ExactRun<N>::end_turn(run::TurnReport& report) {
  const State end = motion_.physical();
  if (!end.allFinite()) return run::Outcome::non_finite;
  turn_start_ = end;
  goes_on_ = true;
  put_section(report.section);
  book_.end_turn(motion_.joint() != 0, report);
  if (tangents_ > 0) motion_.put_tangents(report.tangent_vectors.fill(turn_start_.size(), tangents_));
  return run::Outcome::ok;
}

// Calls of the next two functions are rare; inlined, they would slow every step.
template <int N>
[[gnu::noinline]] void ExactRun<N>::look_for_reversal(run::TurnReport& report, double duration_s) {
  report.slip_reversed |= slip_.reversed_in(motion_, motion_.physical(), duration_s);
}
template <int N>
[[gnu::noinline]] void ExactRun<N>::watch_step(run::TurnReport& report, double duration_s) {
  watch_.end_step(motion_, clock_.time(), duration_s, report);
}

template <int N>
[[gnu::always_inline]] inline void ExactRun<N>::passed(run::TurnReport& report, double duration_s) {
  clock_.go_on(duration_s);
  if (motion_.joint() != 0) {
    slip_.advance(duration_s);
    if (slip_.may_reverse()) look_for_reversal(report, duration_s);
    run::add_contact(clock_.turns(duration_s), report);
  }
  if (watch_.wanted()) watch_step(report, duration_s);
}

/// Takes steps until an event ends them; takes only a single step if something must be observed.
template <int N>
run::Outcome ExactRun<N>::go_on(run::TurnReport& report) {
  watch_.start_step(motion_, clock_.time(), report);
  const bool watched = watch_.wanted();
  const double boundary = std::min(clock_.next_boundary(), watch_.boundary_s(motion_)),
               reach = watch_.reach_s(motion_), longest_step = watch_.longest_step_s(motion_);
  for (;;) {
    const double until = boundary - clock_.time();
    StepChoice choice = choose_step(motion_, {.until_s = until,
                                              .reach_s = reach,
                                              .shortest_to_annular_s = shortest_to_annular * clock_.period(),
                                              .same_instant_s = same_instant * clock_.period()});
    ++book_.effort.steps;
    if (choice.annular) {
      if (flights_only_) hand_over(motion_.physical(), std::nullopt);
      return without_closed_form();
    }
    if (!renew_slip_watch(choice)) return run::Outcome::unsaturated;
    if (choice.crossing != StepChoice::none && !book_.stands_still()) {
      land(report, choice.crossing, choice.step_s);
      return switch_mode(report, choice.crossing) ? run::Outcome::ok : without_closed_form();
    }
    const double step = std::max(std::min(choice.step_s, longest_step), shortest_step * clock_.period());
    if (!(step < until)) return reach_boundary(report, boundary);
    const int k = numerics::exact_step_below(step * motion_.mode().longest_steps_per_s);
    if (k < numerics::exact_step_count) {
      motion_.step_by_table(k);
      passed(report, motion_.mode().longest_step_s * numerics::exact_step_size(k));
    } else {
      motion_.step_by(step);
      passed(report, step);
    }
    book_.note_progress(true);
    if (!std::isfinite(motion_.free()(0))) return run::Outcome::non_finite;
    if (watched || !book_.may_step() || !(clock_.time() < boundary)) return run::Outcome::ok;
  }
}

template <int N>
run::Outcome ExactRun<N>::reach_boundary(run::TurnReport& report, double boundary_s) {
  const double until = boundary_s - clock_.time();
  motion_.step_by(until);
  passed(report, until);
  clock_.go_to(boundary_s);
  if (!clock_.turn_is_over() && !pass_boundary(report)) return without_closed_form();
  return std::isfinite(motion_.free()(0)) ? run::Outcome::ok : run::Outcome::non_finite;
}

/// Handles known instants of a turn: pulses begin or end, impulses act. A pulse is zero at both ends, so that
/// the state and its rate are continuous. But its phasor appears or disappears, and this changes the free
/// vibration on which the bounds on the slips are based.
template <int N>
bool ExactRun<N>::pass_boundary(run::TurnReport& report) {
  if (clock_.change_pulses()) {
    const State here = motion_.physical();
    motion_.set_phases(clock_.phase_rad(), clock_.pulses(), clock_.time());
    if (!motion_.enter(motion_.joint(), here) || !begin_motion(here)) return false;
  }
  return !clock_.impulse_is_due() || apply_impulses(report);
}

/// Applies all impulses of this instant: constant shifts of the state, which leave tangent vectors unchanged.
template <int N>
bool ExactRun<N>::apply_impulses(run::TurnReport& report) {
  State here = motion_.physical();
  const std::size_t from = motion_.joint();
  while (clock_.impulse_is_due())
    here.tail(here.size() / 2) += clock_.take_impulse() / scale_.in_seconds().unit_velocity_m_per_s();
  if (!enter_by_state(here)) return false;
  note_switches(from, motion_.joint(), motion_.mode().modes.size(), clock_.phase_rad(), book_, report);
  return begin_motion(here);
}

template <int N>
void ExactRun<N>::land(run::TurnReport& report, std::size_t e, double latest_s) {
  const double duration_s = motion_.land(e, latest_s);
  passed(report, duration_s);
  book_.note_progress(duration_s > shortest_step * clock_.period());
}

template <int N>
bool ExactRun<N>::switch_mode(run::TurnReport& report, std::size_t e) {
  const State here = motion_.physical();
  if (flights_only_) return hand_over(here, motion_.mode().guards[e].contact);
  const std::size_t joint = joint_mode_behind(motion_, slip_, e, here);
  note_switches(motion_.joint(), joint, motion_.mode().modes.size(), clock_.phase_rad(), book_, report);
  return motion_.change(joint) && begin_motion(here);
}

/// Begins the motion in the mode that was entered at `here`; false as for `begin_slip`.
template <int N>
bool ExactRun<N>::begin_motion(const State& here) {
  if (!begin_slip(here)) return false;
  watch_.begin_motion(motion_);
  return true;
}

/// Begins the slip watch. False where friction is not saturated; the run then ends at `here`.
template <int N>
bool ExactRun<N>::begin_slip(const State& here) {
  return slip_.begin(motion_, here) || hand_over(here, std::nullopt);
}

/// Ends the run at `here`; always false.
template <int N>
bool ExactRun<N>::hand_over(const State& here, std::optional<std::size_t> touches) {
  unsaturated_ = true;
  here_ = here;
  handover_.touches = touches;
  return false;
}

/// Renews the slip watch, whose bounds hold for one longest stretch only.
template <int N>
bool ExactRun<N>::renew_slip_watch(StepChoice& choice) {
  if (motion_.joint() == 0 || slip_.duration_s() + choice.step_s <= slip_.longest_s()) return true;
  if (!begin_slip(motion_.physical())) return false;
  if (choice.step_s > slip_.longest_s()) choice = {.step_s = slip_.longest_s()};
  return true;
}

template class ExactRun<2>;
template class ExactRun<4>;
template class ExactRun<6>;
template class ExactRun<Eigen::Dynamic>;

}  // namespace rubsweep::integrate::exact
