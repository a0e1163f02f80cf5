#pragma once

#include "audit/event_audit.hpp"
#include "audit/random_machine.hpp"

namespace rubsweep::audit {

/// Runs a cell with dry contacts by the exact solver for at most `turns` revolutions. After the kick, the
/// first `most_checked` turns with contact are repeated by time stepping, whose friction shares no code with
/// the solvers. Time stepping converges with its step size. A section is wrong if it is much farther from the
/// finest stepping than the coarser ones are. `difference` is like that of audit_events; its second error is
/// that of the time stepping.
EventAudit audit_dry_contacts(const RandomCell& cell, int turns, int most_checked = 2);

}  // namespace rubsweep::audit
