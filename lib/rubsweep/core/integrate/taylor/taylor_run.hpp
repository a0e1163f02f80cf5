#pragma once

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

/// A run in pieces that are power series of the phase. Within one joint contact mode every law is analytic. A
/// step of order 24 has a length at which its last terms are of the size of rounding. Guards are polynomials
/// over a step; the signs of Bernstein coefficients locate their first rise through zero, so that none is
/// missed. If friction is so steep that the slip follows the other motion, pieces become as long as without
/// friction once the slip's own transient has decayed (`Creep`). With dry friction, pieces also end where a
/// slip reaches zero or a contact stops sticking. Supports flat and annular stops, any friction, any number
/// of coordinates.
template <int N>
class TaylorRun {
 public:
  TaylorRun(const scene::Scene& scene, const run::SolverOptions& options, const SeriesOptions& series = {});

  TaylorRun(const TaylorRun&) = delete;
  TaylorRun& operator=(const TaylorRun&) = delete;

  /// Integrates phases 0 to `end_phase` of the next revolution; an end before 2 pi ends the run.
  run::Outcome advance(const run::TurnRequest& request, run::TurnReport& report,
                       double end_phase = numerics::full_turn);
  /// Begins a revolution of a scene without impulses. `go_on` then makes its pieces, and `finish` completes
  /// it.
  void begin(const run::TurnRequest& request, run::TurnReport& report,
             double end_phase = numerics::full_turn);

  /// Sets SeriesOptions::accuracy from the next piece on.
  void set_series_accuracy(double accuracy) { motion_.set_accuracy(accuracy); }

  /// Starts the next revolution, number `revolution`, from `section` (as TurnReport::section).
  void resume(std::span<const double> section, long revolution);

  /// Continues a revolution of a scene without impulses that another solver has made up to `phase_rad`.
  /// `state` is as TurnReport::section, `tangent_vectors` as TurnRequest::tangent_vectors, `modes` per
  /// contact.
  void join(const run::TurnRequest& request, long revolution, double phase_rad, std::span<const double> state,
            const std::vector<contact::Mode>& modes, const Eigen::MatrixXd& tangent_vectors);
  /// Makes one piece of a turn that was begun or joined, and continues `report`. After `ok` the run is at
  /// `phase_rad()`.
  run::Outcome go_on(run::TurnReport& report) {
    const bool may_go_on = book_.may_step() && expansions_ < expansion_limit_;
    return may_go_on ? step(report) : run::Outcome::step_limit;
  }
  /// Whether the last piece reached the end of the turn.
  bool at_end_of_turn() const { return clock_.turn_is_over(); }
  /// Completes the report of a turn that was begun or joined and has reached its end.
  void finish(run::TurnReport& report) { end(report, run::Outcome::ok); }

  double phase_rad() const { return clock_.time(); }
  /// Whether dry friction holds a contact.
  bool sticks() const { return dynamics_.any_dry() && dynamics_.stuck_contacts().count > 0; }
  const std::vector<contact::Mode>& modes() const { return dynamics_.modes(); }
  /// Slips of the contacts, valid for touching contacts with dry friction.
  const std::vector<contact::Slip>& slips() const { return dynamics_.slips(); }
  /// Present tangent vectors, as many as were given.
  const Eigen::MatrixXd& tangents() const { return tangents_.vectors(); }

  /// Present scaled state: the start of the next revolution, or a state within a joined turn.
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
  void switch_modes(run::TurnReport& report, const JointEvent& event, double duration);
  void stop_slip(std::size_t i);
  void let_go(std::size_t i, contact::Slip slip, double duration);
  void settle_poised();
  void project_tangents();
  void apply_impulses(run::TurnReport& report);
  void note_switch(run::TurnReport& report, std::size_t i, contact::Mode from);
  run::Outcome end(run::TurnReport& report, run::Outcome ending);

  run::ScaledSystem<N> system_;
  law::Dynamics<N, false> dynamics_;
  Expansion<N> motion_;
  TangentExpansion<N> tangents_;
  run::TurnClock clock_;       ///< clock in radians
  double structure_rate_ = 0;  ///< fastest rate of the structure without contacts, per radian
  CreepChoice<N> creep_;
  double tangent_accuracy_ = 0;
  double longest_of_tangents_ = 0;  ///< largest product of a step and the fastest rate with tangent vectors
  run::TurnBook book_;
  long max_steps_ = 0;
  /// Counts expansions: a piece with creep takes several, also if the search for creep fails.
  long expansions_ = 0, expansion_limit_ = 0;
  std::vector<double> state_, rate_, probe_, states_;
  std::vector<contact::Mode> modes_before_;
  SlipZeros zeros_;
  bool entered_ = false;
  int samples_wanted_ = 0;  ///< samples requested in this turn
  bool peaks_wanted_ = false;
};

}  // namespace rubsweep::integrate::taylor
