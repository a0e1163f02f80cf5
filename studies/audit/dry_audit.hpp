#pragma once

#include "audit/event_audit.hpp"
#include "audit/random_machine.hpp"

namespace rubsweep::audit {

/// Runs a cell whose contacts are dry by the exact solver for at most `turns` revolutions. Of those behind
/// the kick in which something touches, the first `most_checked` are made again by time stepping, whose
/// friction shares no code with the solvers. That converges as its steps get smaller: a section is wrong that
/// is farther from the finest one than that is from those before, by far. `difference` is as of audit_events,
/// its second error that of the time stepping.
EventAudit audit_dry_contacts(const RandomCell& cell, int turns, int most_checked = 2);

}  // namespace rubsweep::audit
