#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "rubsweep/core/integrate/exact/exact_motion.hpp"
#include "rubsweep/core/integrate/exact/slip_watch.hpp"
#include "rubsweep/core/integrate/exact/step_choice.hpp"
#include "rubsweep/core/integrate/exact/turn_watch.hpp"
#include "rubsweep/core/integrate/run/outcome.hpp"
#include "rubsweep/core/integrate/run/turn_book.hpp"
#include "rubsweep/core/integrate/run/turn_clock.hpp"

namespace rubsweep::integrate::exact {

/// A run between flat stops with saturated friction, without truncation error. Inside a contact mode the
/// state follows the mode's exact flow. Certified steps find the mode switches. With a bound M on the second
/// derivative of every guard function g, g + g' t + M t^2 / 2 stays negative over the whole step. So no guard
/// is missed, not even in a graze. A crossing is accepted where M proves g monotone up to it. Annular stops
/// are supported while they are not touched.
template <int N>
class ExactRun {
 public:
  /// `modes` must have been made for the scene. With `flights_only` a contact that touches ends the run as
  /// friction does that leaves saturation.
  ExactRun(const scene::Scene& scene, std::shared_ptr<modes::MachineModes<N>> modes,
           long max_steps_per_revolution, bool flights_only = false);

  /// Integrates the next revolution. After `no_closed_form` the run is back at the start of the revolution,
  /// and the report is undefined. After `unsaturated`, turn and report are complete up to `handover()`.
  run::Outcome advance(const run::TurnRequest& request, run::TurnReport& report);

  /// State during a turn, from which another solver continues.
  struct Handover {
    double phase_rad = 0;
    std::vector<double> state;         ///< state as in TurnReport::section
    std::vector<contact::Mode> modes;  ///< mode of each contact
    Eigen::MatrixXd tangent_vectors;   ///< vectors as in TurnRequest::tangent_vectors
    /// Contact of a flight that touches at this instant. Empty: none, or one will within a moment.
    std::optional<std::size_t> touches;
  };
  const Handover& handover();  ///< State after `unsaturated`. Its memory is reused.

  /// Continues a turn of another solver, which made `report` up to this point. False, with nothing changed,
  /// where friction is not saturated, or would be for a moment only.
  bool join(double phase_rad, std::span<const double> state, const std::vector<contact::Mode>& modes,
            const run::TurnReport& report);
  /// Completes the turn after `join`, as `advance` does.
  run::Outcome go_to_end(const Eigen::MatrixXd& tangent_vectors, run::TurnReport& report);

  /// Begins the report of a turn that another solver begins. Returns whether the acting pulses change.
  bool begin_elsewhere(const run::TurnRequest& request, run::TurnReport& report);

  /// Starts the next revolution from `section` (as TurnReport::section), after turns made by another solver.
  void resume(std::span<const double> section);

  /// Returns to the start of revolution 0, with another section.
  void restart(std::span<const double> section) {
    resume(section);
    book_.revolution = 0;
  }

  /// Scaled state at the start of the next turn, as TurnReport::section.
  std::vector<double> section() const;
  /// Writes the section without an allocation, once `section` is large enough.
  void put_section(std::vector<double>& section) const { scale_.put_section(turn_start_, section); }
  long revolution() const { return book_.revolution; }
  const run::Effort& effort() const { return book_.effort; }

 private:
  using Motion = ExactMotion<N>;
  using State = typename Motion::State;

  bool begin_turn(const run::TurnRequest& request, run::TurnReport& report);
  run::Outcome run_to_end(run::TurnReport& report);
  bool start_motion(bool pulses_changed);
  run::Outcome end_turn(run::TurnReport& report);
  bool enter_by_state(const State& physical);
  run::Outcome go_on(run::TurnReport& report);
  run::Outcome reach_boundary(run::TurnReport& report, double boundary_s);
  bool pass_boundary(run::TurnReport& report);
  bool apply_impulses(run::TurnReport& report);
  void passed(run::TurnReport& report, double duration_s);
  void look_for_reversal(run::TurnReport& report, double duration_s);
  void watch_step(run::TurnReport& report, double duration_s);
  void land(run::TurnReport& report, std::size_t guard, double latest_s);
  bool switch_mode(run::TurnReport& report, std::size_t guard);
  bool begin_motion(const State& here);
  bool begin_slip(const State& here);
  bool renew_slip_watch(StepChoice& choice);
  bool hand_over(const State& here, std::optional<std::size_t> touches);
  run::Outcome without_closed_form() const {
    return unsaturated_ ? run::Outcome::unsaturated : run::Outcome::no_closed_form;
  }

  Motion motion_;
  run::StateScale scale_;  ///< scale of sections
  run::TurnClock clock_;   ///< clock in seconds
  SlipWatch<N> slip_;
  TurnWatch<N> watch_;
  run::TurnBook book_;
  long max_steps_ = 0;  ///< limit for a turn
  bool flights_only_ = false;

  State turn_start_;           ///< unscaled state
  bool goes_on_ = false;       ///< true: the motion is where the last turn ended
  Eigen::Index tangents_ = 0;  ///< number of vectors requested in this turn
  bool unsaturated_ = false;   ///< true: friction leaves saturation at the present point of the turn
  State here_;                 ///< unscaled state at that point
  Handover handover_;
};

}  // namespace rubsweep::integrate::exact
