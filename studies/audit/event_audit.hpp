#pragma once

#include <optional>
#include <string>

#include "audit/random_machine.hpp"
#include "rubsweep/core/integrate/run/outcome.hpp"
#include "rubsweep/core/integrate/run/turn.hpp"

namespace rubsweep::audit {

/// Difference of the exact solver and rkf78 at 1e-13 over one revolution from the same section.
struct EventDifference {
  long turn = 0;             ///< turn, counted from 1 at the start of the kick
  double exact_error = 0;    ///< distance of the exact section from the fixed-step reference, in clearances
  double other_error = 0;    ///< distance of rkf78's section from the same reference
  std::string first_switch;  ///< first change of contact mode that only one solver has
};

struct EventAudit {
  long turns = 0;              ///< turns compared
  long touched = 0;            ///< turns with contact
  long exact_turns = 0;        ///< turns with contact by closed forms alone
  long turns_with_pieces = 0;  ///< turns with Taylor pieces
  /// Turns in which both solvers agree although they saw different mode changes: a graze below the tolerance.
  long grazes = 0;
  /// Turns with equal mode changes but a difference above the tolerance, which the exact solver gave to
  /// dopri5: the effect of dopri5's tolerance on a strongly diverging motion.
  long parted = 0;
  /// Turns repeated by time stepping: with a sticking contact, and with two slips at zero at once.
  long stuck = 0, stuck_together = 0;
  integrate::run::Outcome outcome = integrate::run::Outcome::ok;  ///< outcome of the last turn
  bool exact_failed = false, other_failed = false;                ///< a solver did not finish a turn
  std::optional<EventDifference> difference;                      ///< first error of the exact solver
  /// Turns in which the solvers differ and the reference shows that rkf78 is wrong.
  long other_wrong = 0;
};

/// Runs a cell by the exact solver for at most `turns` revolutions. Each revolution after the kick is
/// repeated by rkf78 at tolerance 1e-13 from the same section, so that chaos separates both for one turn
/// only. Where they differ by more than `tolerance` clearances, a fixed-step integration without event
/// location decides. Ends at the first error of the exact solver, or when the rotor had no contact for
/// `free_turns` revolutions.
EventAudit audit_events(const RandomCell& cell, int turns, double tolerance = 1e-7);

}  // namespace rubsweep::audit
