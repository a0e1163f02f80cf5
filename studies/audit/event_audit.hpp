#pragma once

#include <optional>
#include <string>

#include "audit/random_machine.hpp"
#include "rubsweep/core/integrate/run/outcome.hpp"
#include "rubsweep/core/integrate/run/turn.hpp"

namespace rubsweep::audit {

/// Difference of the exact solver and rkf78 at 1e-13 over one revolution from the same section.
struct EventDifference {
  long turn = 0;             ///< from the start of the kick, 1 is the first
  double exact_error = 0;    ///< distance of the exact section from the fixed-step reference, in clearances
  double other_error = 0;    ///< the same of rkf78
  std::string first_switch;  ///< the first change of contact mode that the two do not share
};

struct EventAudit {
  long turns = 0;              ///< compared
  long touched = 0;            ///< of these with contact
  long exact_turns = 0;        ///< of these made by closed forms alone
  long turns_with_pieces = 0;  ///< with Taylor pieces, where there are none
  /// The two saw different changes of mode and still agree: a graze below the other's tolerance.
  long grazes = 0;
  /// Farther apart than the tolerance with the same changes of mode, in a turn that the exact solver handed
  /// to dopri5: the effect of that tolerance on a strongly diverging motion.
  long parted = 0;
  /// Made again by time stepping: with a contact that dry friction holds, and with two slips at zero at once.
  long stuck = 0, stuck_together = 0;
  integrate::run::Outcome outcome = integrate::run::Outcome::ok;  ///< of the last turn by the exact solver
  bool exact_failed = false, other_failed = false;                ///< a solver did not finish a turn
  std::optional<EventDifference> difference;                      ///< the exact solver is wrong
  /// The two differ, and the reference says that rkf78 is the one that is wrong.
  long other_wrong = 0;
};

/// Runs a cell by the exact solver for at most `turns` revolutions. Each revolution behind the kick is made
/// again by rkf78 at tolerance 1e-13 from the same section, so that chaos has one turn to part the two at
/// most; where they differ by more than `tolerance` clearances a fixed-step integration that locates no
/// events says which is right. Ends after the first difference that is the exact solver's fault, and where
/// the rotor has been free for `free_turns` revolutions.
EventAudit audit_events(const RandomCell& cell, int turns, double tolerance = 1e-7);

}  // namespace rubsweep::audit
