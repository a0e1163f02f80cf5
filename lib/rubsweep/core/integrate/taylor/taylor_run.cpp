#include "rubsweep/core/integrate/taylor/taylor_run.hpp"

#include <algorithm>
#include <cmath>

#include "rubsweep/core/integrate/law/settle_slips.hpp"
#include "rubsweep/core/integrate/run/work_bound.hpp"
#include "rubsweep/core/integrate/taylor/joint_event.hpp"
#include "rubsweep/core/integrate/taylor/piece_report.hpp"
#include "rubsweep/core/integrate/taylor/step_length.hpp"
#include "rubsweep/core/numerics/dense/eigenvalues.hpp"
#include "rubsweep/core/numerics/matrix_flow.hpp"

namespace rubsweep::integrate::taylor {
namespace {

using contact::Mode;

constexpr double same_instant = 1e-13;  ///< radians: shorter landings make no progress
constexpr int most_expansions = 4;      ///< number of expansions for each piece that a turn may have

}  // namespace

template <int N>
TaylorRun<N>::TaylorRun(const scene::Scene& scene, const run::SolverOptions& options,
                        const SeriesOptions& series)
    : system_(run::scale<N>(scene)),
      dynamics_(system_, 0),
      motion_(system_, series),
      tangents_(system_),
      clock_(run::TurnClock::in_radians(scene, system_.scale)),
      structure_rate_(
          numerics::dense::spectral_radius(numerics::generator_of(system_.stiffness, system_.damping))),
      creep_(series.creep_above),
      max_steps_(run::most_pieces_of_a_turn(options)),
      state_(run::scaled_initial_state(scene)),
      rate_(state_.size()),
      probe_(state_.size()),
      states_(static_cast<std::size_t>(most_peak_states) * state_.size()),
      zeros_(system_.contacts.size()) {
  dynamics_.follow(clock_.pulses());
}

template <int N>
void TaylorRun<N>::resume(std::span<const double> section, long revolution) {
  std::copy(section.begin(), section.end(), state_.begin());
  book_.revolution = revolution;
  entered_ = false;
}

template <int N>
void TaylorRun<N>::begin(const run::TurnRequest& request, run::TurnReport& report, double end_phase) {
  report.clear();
  ask(request);
  if (samples_wanted_ > 0) report.samples.resize(static_cast<std::size_t>(samples_wanted_) * state_.size());
  clock_.begin_turn(book_.revolution, end_phase);
  if (!entered_) enter_by_state();
  entered_ = true;
  begin_tangents(request.tangent_vectors, request.tangent_accuracy);
}

template <int N>
run::Outcome TaylorRun<N>::advance(const run::TurnRequest& request, run::TurnReport& report,
                                   double end_phase) {
  begin(request, report, end_phase);
  run::Outcome ending = run::Outcome::ok;
  while (ending == run::Outcome::ok && !clock_.turn_is_over()) {
    if (clock_.impulse_is_due()) apply_impulses(report);
    ending = go_on(report);
  }
  return end(report, ending);
}

template <int N>
void TaylorRun<N>::ask(const run::TurnRequest& request) {
  samples_wanted_ = request.samples_per_revolution;
  peaks_wanted_ = request.peaks;
  book_.begin_turn(request);
  creep_.begin_turn();
  book_.limit_steps(max_steps_);
  expansion_limit_ = expansions_ + most_expansions * max_steps_;
}

template <int N>
void TaylorRun<N>::begin_tangents(const Eigen::MatrixXd& vectors, double accuracy) {
  tangents_.begin(vectors);
  if (tangents_.count() == 0) return;
  project_tangents();
  tangent_accuracy_ = accuracy;
  longest_of_tangents_ = longest_times_fastest_of_tangents(accuracy);
}

template <int N>
void TaylorRun<N>::join(const run::TurnRequest& request, long revolution, double phase_rad,
                        std::span<const double> state, const std::vector<contact::Mode>& modes,
                        const Eigen::MatrixXd& tangent_vectors) {
  ask(request);
  book_.revolution = revolution;
  clock_.begin_turn(revolution);
  clock_.go_to(phase_rad);
  clock_.change_pulses();
  std::copy(state.begin(), state.end(), state_.begin());
  dynamics_.modes() = modes;
  zeros_.clear();
  law::enter_slips_by_state(dynamics_, state_, rate_, clock_.time());
  entered_ = true;
  begin_tangents(tangent_vectors, request.tangent_accuracy);
}

template <int N>
run::Outcome TaylorRun<N>::end(run::TurnReport& report, run::Outcome ending) {
  report.effort = effort();
  if (ending != run::Outcome::ok) return ending;
  report.section = state_;
  book_.end_turn(std::ranges::any_of(dynamics_.modes(), [](Mode mode) { return mode != Mode::open; }),
                 report);
  if (tangents_.count() > 0)
    report.tangent_vectors.fill(static_cast<Eigen::Index>(state_.size()), tangents_.count()) =
        tangents_.vectors();
  return ending;
}

/// Sets modes and slips from the state.
template <int N>
void TaylorRun<N>::enter_by_state() {
  clock_.change_pulses();
  const double phase = clock_.time();
  std::ranges::fill(dynamics_.modes(), Mode::open);
  zeros_.clear();
  dynamics_(state_, rate_, phase);
  for (std::size_t i = 0; i < system_.contacts.size(); ++i) dynamics_.enter_by_state(i, state_, rate_);
  law::enter_slips_by_state(dynamics_, state_, rate_, phase);
}

/// Projects tangent vectors onto the sticking constraint, because friction stops any slip at once.
template <int N>
void TaylorRun<N>::project_tangents() {
  if (tangents_.count() > 0 && sticks()) dynamics_.keep_sticking(state_, tangents_.vectors());
}

template <int N>
double TaylorRun<N>::longest_step(double fastest) const {
  if (tangents_.count() == 0) return longest_times_fastest / fastest;
  return longest_of_tangents_ / (fastest + 2 * fastest_normal(motion_, dynamics_.modes()));
}

template <int N>
run::Outcome TaylorRun<N>::step(run::TurnReport& report) {
  if (dynamics_.unsettled()) return run::Outcome::friction_unsettled;
  clock_.change_pulses();
  creep_.end(motion_, dynamics_);
  expand(state_);
  ++book_.effort.steps;
  const double fastest = fastest_rate(structure_rate_, motion_, dynamics_.modes());
  const double boundary = clock_.next_boundary(), left = boundary - clock_.time();
  double ratio = friction_ratio(motion_, dynamics_, state_);
  const bool creeps = try_creep(fastest, ratio);
  if (creeps) ratio = friction_ratio(motion_, dynamics_, state_);
  double wanted = motion_.series().converged_rad(longest_step(fastest * std::max(1.0, ratio)));
  if (creeps) wanted = std::min(wanted, creep_.known_rad());
  for (std::size_t i = 0; i < system_.contacts.size(); ++i)
    wanted = guards_converged_rad(motion_.contact(i), motion_.order(), motion_.accuracy(), wanted);
  if (!(wanted > 0)) return run::Outcome::non_finite;
  if (book_.stands_still()) {
    // A landing without progress is not repeated: its instant is stepped over.
    const double instant = std::min(same_instant, left);
    take(report, fastest, instant, instant < left ? clock_.time() + instant : boundary);
    switch_modes(report, {}, instant);
    book_.note_progress(true);
    return run::Outcome::ok;
  }
  const bool limited = wanted >= left;
  double duration = limited ? left : wanted;
  const JointEvent event = first_event(motion_, dynamics_, zeros_.terms(), duration);
  const bool cut = event.share < 1 || event.contact;
  duration *= event.share;
  if (!take(report, fastest, duration,
            cut       ? clock_.time() + duration
            : limited ? boundary
                      : clock_.time() + duration)) {
    creep_.wait();
    --book_.effort.steps;
    return step(report);
  }
  if (creeps) ++book_.effort.creep_pieces;
  if (!std::isfinite(state_[0])) return run::Outcome::non_finite;
  book_.note_progress(duration > same_instant);
  if (event.contact) switch_modes(report, event, duration);
  return run::Outcome::ok;
}

template <int N>
void TaylorRun<N>::expand(const std::vector<double>& state) {
  ++expansions_;
  ++book_.effort.taylor_work;
  motion_.expand(state.data(), clock_.time(), clock_.pulses(), dynamics_.modes(), dynamics_.slips(),
                 dynamics_.poised());
}

/// Repeats the expansion with creeping contacts, or leaves it as it is.
template <int N>
bool TaylorRun<N>::try_creep(double fastest, double ratio) {
  if (!book_.made_progress() || !creep_.due(ratio)) return false;
  return creep_.begin(
      motion_, dynamics_, [this](const std::vector<double>& state) { expand(state); }, state_, probe_,
      longest_step(fastest), longest_step(fastest * ratio));
}

/// Moves on by `duration` within the modes of the expansion, and takes the requested peaks and samples.
/// False, with nothing done, where contacts creep but their tangent vectors still contain a transient.
template <int N>
bool TaylorRun<N>::take(run::TurnReport& report, double fastest, double duration, double end_phase) {
  const bool moved = tangents_.pass(motion_, duration, tangent_accuracy_);
  book_.effort.taylor_work +=
      run::share_of_a_tangent * static_cast<double>(tangents_.count() + tangents_.take_sweeps());
  if (!moved) return false;
  put_samples(motion_, clock_.time(), end_phase, samples_wanted_, report);
  note_contact(motion_, dynamics_.modes(), duration, report);
  if (peaks_wanted_) note_peaks(motion_, system_, dynamics_.modes(), fastest, duration, states_, report);
  motion_.series().put_state(duration, state_.data());
  clock_.go_to(end_phase);
  zeros_.clear();
  return true;
}

template <int N>
void TaylorRun<N>::note_switch(run::TurnReport& report, std::size_t i, Mode from) {
  book_.note_switch({clock_.time(), static_cast<int>(i), from, dynamics_.modes()[i]}, report);
}

/// Makes the switch of `event` at the end of the piece, which took `duration`. The force is continuous at the
/// switch of a mode, so that the rate is the same on both sides of it.
template <int N>
void TaylorRun<N>::switch_modes(run::TurnReport& report, const JointEvent& event, double duration) {
  clock_.change_pulses();
  dynamics_(state_, rate_, clock_.time());
  if (event.slip) {
    ++book_.effort.switches;
    if (*event.slip == contact::Slip::sticking) {
      stop_slip(*event.contact);
    } else {
      let_go(*event.contact, *event.slip, duration);
    }
  }
  for (std::size_t i = 0; i < system_.contacts.size(); ++i) {
    Mode& mode = dynamics_.modes()[i];
    const Mode from = mode;
    const contact::Kinematics kinematics = dynamics_.kinematics(i, state_, rate_);
    if (event.contact == i && !event.slip) mode = contact::mode_through(from, event.next, kinematics);
    mode = dynamics_.mode_after(i, mode, kinematics);
    if (mode == from) continue;
    note_switch(report, i, from);
    if (mode == Mode::open && dynamics_.any_poised()) settle_poised();
    if (from != Mode::open || !dynamics_.touches_dry(i)) continue;
    law::take_slip_of_state(dynamics_, i, state_);
    if (dynamics_.slips()[i] == contact::Slip::sticking) stop_slip(i);
  }
}

/// Handles contact `i` whose slip reaches zero; `rate_` is the rate before this event.
template <int N>
void TaylorRun<N>::stop_slip(std::size_t i) {
  zeros_.stop(dynamics_, i, state_, probe_, clock_.time());
  dynamics_(state_, probe_, clock_.time());
  if (tangents_.count() > 0) law::cross_slip(dynamics_, i, state_, rate_, probe_, tangents_.vectors());
  std::swap(rate_, probe_);
}

/// Releases contact `i`, which friction no longer holds at the end of a piece of `duration`; `rate_` is the
/// rate before the release. Tangent vectors jump if the rate does, that is, if friction drops as soon as the
/// contact slips.
template <int N>
void TaylorRun<N>::let_go(std::size_t i, contact::Slip slip, double duration) {
  if (!dynamics_.jumps(i)) return zeros_.let_go(dynamics_, i, slip, state_, probe_, clock_.time());
  Eigen::RowVectorXd gradient;
  if (tangents_.count() > 0) gradient = dynamics_.reserve_gradient(i, slip, state_, probe_, clock_.time());
  zeros_.let_go(dynamics_, i, slip, state_, probe_, clock_.time());
  dynamics_(state_, probe_, clock_.time());
  if (tangents_.count() > 0) {
    const double way = reserve_rate(motion_.contact(i), motion_.order(), duration, slip);
    law::cross(gradient, way, rate_, probe_, tangents_.vectors());
  }
  std::swap(rate_, probe_);
}

/// Settles poised contacts again after another contact, which may have held them, has opened.
template <int N>
void TaylorRun<N>::settle_poised() {
  law::settle_slips(dynamics_, state_, probe_, clock_.time(), [](std::size_t) { return false; });
  dynamics_(state_, rate_, clock_.time());
}

/// Applies all impulses of this instant: constant shifts of the state, which leave tangent vectors unchanged.
template <int N>
void TaylorRun<N>::apply_impulses(run::TurnReport& report) {
  while (clock_.impulse_is_due()) run::add_impulse(clock_.take_impulse(), system_.scale, state_);
  modes_before_ = dynamics_.modes();
  enter_by_state();
  project_tangents();
  for (std::size_t i = 0; i < modes_before_.size(); ++i) {
    if (dynamics_.modes()[i] != modes_before_[i]) note_switch(report, i, modes_before_[i]);
  }
}

template class TaylorRun<2>;
template class TaylorRun<4>;
template class TaylorRun<6>;
template class TaylorRun<Eigen::Dynamic>;

}  // namespace rubsweep::integrate::taylor
