#pragma once

#include <optional>
#include <span>
#include <vector>

#include "rubsweep/core/integrate/law/dynamics.hpp"
#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/core/integrate/run/outcome.hpp"
#include "rubsweep/core/integrate/run/scaled_system.hpp"
#include "rubsweep/core/integrate/run/turn_book.hpp"
#include "rubsweep/core/integrate/run/turn_clock.hpp"
#include "rubsweep/core/integrate/taylor/creep_choice.hpp"
#include "rubsweep/core/integrate/taylor/expansion.hpp"
#include "rubsweep/core/integrate/taylor/joint_event.hpp"
#include "rubsweep/core/integrate/taylor/slip_zeros.hpp"
#include "rubsweep/core/integrate/taylor/tangent_expansion.hpp"
#include "rubsweep/core/numerics/full_turn.hpp"

namespace rubsweep::integrate::taylor {

/// A run in pieces that are power series of the phase: within one joint contact mode every law is analytic,
/// so that a step of order 24 is as long as its last terms are rounding. Guards are polynomials over a step,
/// whose first rise through zero is found by signs of Bernstein coefficients, so that none is passed over. In
/// friction so steep that the slip follows the rest of the motion, pieces are as long as without it
/// (`Creep`), once the slip's own transient has died out. With dry friction pieces end, too, where a slip
/// comes to zero and where a contact that sticks is let go. Takes flat and annular stops, any friction, any
/// number of coordinates.
template <int N>
class TaylorRun {
 public:
  TaylorRun(const scene::Scene& scene, const run::SolverOptions& options, const SeriesOptions& series = {});

  TaylorRun(const TaylorRun&) = delete;
  TaylorRun& operator=(const TaylorRun&) = delete;

  /// Integrates phases 0 to `end_phase` of the next revolution; the run is over when that is less than 2 pi.
  run::Outcome advance(const run::TurnRequest& request, run::TurnReport& report,
                       double end_phase = numerics::full_turn);
  /// Begins a revolution that `go_on` makes in pieces and `finish` completes, of a scene without impulses.
  void begin(const run::TurnRequest& request, run::TurnReport& report,
             double end_phase = numerics::full_turn);

  /// As SeriesOptions::accuracy, from the next piece on.
  void set_series_accuracy(double accuracy) { motion_.set_accuracy(accuracy); }

  /// The next revolution is number `revolution` and starts from `section` (as TurnReport::section).
  void resume(std::span<const double> section, long revolution);

  /// Takes over a revolution of a scene without impulses, which another solver has made up to `phase_rad`: at
  /// `state` (as TurnReport::section), with these modes of its contacts and these tangent vectors (as
  /// TurnRequest::tangent_vectors).
  void join(const run::TurnRequest& request, long revolution, double phase_rad, std::span<const double> state,
            const std::vector<contact::Mode>& modes, const Eigen::MatrixXd& tangent_vectors);
  /// One piece of the turn that was begun or joined; `report` goes on. After `ok` the run is at
  /// `phase_rad()`.
  run::Outcome go_on(run::TurnReport& report) {
    const bool may_go_on = book_.may_step() && expansions_ < expansion_limit_;
    return may_go_on ? step(report) : run::Outcome::step_limit;
  }
  /// Whether the last piece reached the end of the turn.
  bool at_end_of_turn() const { return clock_.turn_is_over(); }
  /// Completes the report of a turn that was begun or joined and is at its end.
  void finish(run::TurnReport& report) { end(report, run::Outcome::ok); }

  double phase_rad() const { return clock_.time(); }
  /// Dry friction holds a contact.
  bool sticks() const { return dynamics_.any_dry() && dynamics_.stuck_contacts().count > 0; }
  /// Whether a contact has just been let go whose friction is less since then: by its slip alone, which is
  /// zero, it would be held again.
  bool just_let_go() const {
    for (std::size_t i = 0; i < zeros_.terms().size(); ++i)
      if (zeros_.terms()[i] > 0 && dynamics_.jumps(i)) return true;
    return false;
  }
  const std::vector<contact::Mode>& modes() const { return dynamics_.modes(); }
  /// Slips of the contacts, valid for those that touch with dry friction.
  const std::vector<contact::Slip>& slips() const { return dynamics_.slips(); }
  /// As many tangent vectors as were given, where they are now.
  const Eigen::MatrixXd& tangents() const { return tangents_.vectors(); }

  /// Scaled state where the run is: where the next revolution begins, or in the turn that was joined.
  const std::vector<double>& section() const { return state_; }
  long revolution() const { return book_.revolution; }
  run::Effort effort() const {
    run::Effort effort = book_.effort;
    effort.taylor_pieces = effort.steps;
    return effort;
  }

 private:
  void ask(const run::TurnRequest& request);
  void begin_tangents(const Eigen::MatrixXd& vectors, double accuracy);
  void enter_by_state();
  run::Outcome step(run::TurnReport& report);
  double longest_step(double fastest) const;
  void expand(const std::vector<double>& state);
  bool try_creep(double fastest, double ratio);
  bool take(run::TurnReport& report, double fastest, double duration, double end_phase);
  void put_samples(run::TurnReport& report, double end_phase);
  void watch(run::TurnReport& report, double fastest, double duration);
  void switch_modes(run::TurnReport& report, const JointEvent& event);
  void stop_slip(std::size_t i);
  void let_go(std::size_t i, contact::Slip slip);
  void settle_poised();
  void project_tangents();
  void apply_impulses(run::TurnReport& report);
  void note_switch(run::TurnReport& report, std::size_t i, contact::Mode from);
  run::Outcome end(run::TurnReport& report, run::Outcome ending);

  run::ScaledSystem<N> system_;
  law::Dynamics<N, false> dynamics_;
  Expansion<N> motion_;
  TangentExpansion<N> tangents_;
  run::TurnClock clock_;       ///< in radians
  double structure_rate_ = 0;  ///< fastest of the structure without contacts, per radian
  CreepChoice<N> creep_;
  double tangent_accuracy_ = 0;
  double longest_of_tangents_ = 0;  ///< step times the fastest rate of what they excite
  run::TurnBook book_;
  long max_steps_ = 0;
  /// Where contacts creep a piece takes several, and a search for creep that fails takes them for nothing.
  long expansions_ = 0, expansion_limit_ = 0;
  std::vector<double> state_, rate_, probe_, states_;
  std::vector<contact::Mode> modes_before_;
  SlipZeros zeros_;
  double reserve_rate_ = 0;  ///< rate of the friction's reserve at a contact that is let go
  bool entered_ = false;
  int samples_wanted_ = 0;  ///< as asked for in this turn
  bool peaks_wanted_ = false;
};

extern template class TaylorRun<2>;
extern template class TaylorRun<4>;
extern template class TaylorRun<6>;
extern template class TaylorRun<Eigen::Dynamic>;

}  // namespace rubsweep::integrate::taylor
