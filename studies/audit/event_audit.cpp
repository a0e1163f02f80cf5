#include "audit/event_audit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "audit/fixed_step_turn.hpp"
#include "audit/section_distance.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "rubsweep/core/response/proof/section_map.hpp"
#include "rubsweep/core/scene/build_scene.hpp"

namespace rubsweep::audit {
namespace {

using integrate::run::ModeSwitch;
using integrate::run::Outcome;
using integrate::run::TurnReport;
using integrate::run::TurnRequest;

constexpr int free_turns = 3;
constexpr int reference_steps = 400'000;
/// Factor by which the reference must be closer to one of two sections to call the other one wrong.
constexpr double clearly = 3;

integrate::run::SolverOptions options(integrate::run::Method method) {
  integrate::run::SolverOptions solver;
  solver.method = method;
  if (method == integrate::run::Method::adaptive) {
    solver.stepper = integrate::run::Stepper::rkf78;
    solver.relative_tolerance = 1e-13;
  } else {
    solver.relative_tolerance = 1e-12;  // tolerance of turns without closed forms
  }
  return solver;
}

std::string text(const ModeSwitch& at) {
  return fmt::format("stop {} {}>{} at {:.12f} turns", at.contact, contact::to_string(at.from),
                     contact::to_string(at.to), at.phase_rad / 6.283185307179586);
}

/// First change that differs between both lists; empty if they agree, apart from the order at equal instants.
std::string first_unshared(std::vector<ModeSwitch> a, std::vector<ModeSwitch> b) {
  constexpr double same_instant_rad = 1e-6;
  for (const ModeSwitch& at : a) {
    const auto twin = std::ranges::find_if(b, [&](const ModeSwitch& other) {
      return other.contact == at.contact && other.from == at.from && other.to == at.to &&
             std::abs(other.phase_rad - at.phase_rad) < same_instant_rad;
    });
    if (twin == b.end()) return text(at) + " by exact alone";
    b.erase(twin);
  }
  return b.empty() ? "" : text(b.front()) + " by rkf78 alone";
}

double largest_of(const std::vector<double>& section) {
  double largest = 0;
  for (const double value : section) largest = std::max(largest, std::abs(value));
  return largest;
}

}  // namespace

EventAudit audit_events(const RandomCell& random, int turns, double tolerance) {
  EventAudit audit;
  const scene::Cell cell =
      scene::build_cell(random.machine, random.speed_hz, scene::WhirlRatio{random.whirl_ratio});
  if (cell.start != scene::Start::quiet) return audit;
  const scene::Scene free = response::proof::after_the_kick(cell.scene);
  integrate::exact::modes::ModeCache modes;
  const integrate::run::Run exact =
      integrate::start(cell.scene, options(integrate::run::Method::exact), modes);
  const integrate::run::Run other = integrate::start(free, options(integrate::run::Method::adaptive), modes);
  const double kick_turns = random.machine.kick ? random.machine.kick->duration_s * random.speed_hz : 0;
  TurnRequest asked;
  TurnReport turn, again;
  asked.switches = true;
  std::vector<double> before;
  long adaptive_turns = 0, taylor_turns = 0;
  for (int k = 0, quiet = 0; k < turns && quiet < free_turns; ++k) {
    before = turn.section;
    audit.outcome = exact.advance(asked, turn);
    if (audit.outcome != Outcome::ok) {
      audit.exact_failed = true;
      return audit;
    }
    if (k < kick_turns) continue;
    quiet = turn.touched ? 0 : quiet + 1;
    const bool closed_form =
        turn.effort.adaptive_turns == std::exchange(adaptive_turns, turn.effort.adaptive_turns);
    const bool pieces = turn.effort.taylor_turns != std::exchange(taylor_turns, turn.effort.taylor_turns);
    other.restart(before);
    if (other.advance(asked, again) != Outcome::ok) {
      audit.other_failed = true;
      continue;
    }
    ++audit.turns;
    audit.touched += turn.touched;
    audit.exact_turns += closed_form && !pieces;
    audit.turns_with_pieces += pieces;
    const std::string unshared = first_unshared(turn.switches, again.switches);
    const double apart = section_distance(turn.section, again.section);
    // With constant friction a dry whip grows without limit, so the error is relative to its size.
    if (apart <= tolerance * std::max(1.0, largest_of(again.section))) {
      audit.grazes += !unshared.empty();
      continue;
    }
    if (!closed_form && unshared.empty()) {
      ++audit.parted;
      continue;
    }
    const auto reference = fixed_step_turn(free, before, reference_steps);
    const double exact_error = section_distance(turn.section, reference),
                 other_error = section_distance(again.section, reference);
    if (exact_error > clearly * other_error) {
      audit.difference = EventDifference{k + 1, exact_error, other_error, unshared};
      return audit;
    }
    ++audit.other_wrong;
  }
  return audit;
}

}  // namespace rubsweep::audit
