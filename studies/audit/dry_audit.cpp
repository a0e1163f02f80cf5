#include "audit/dry_audit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include "audit/section_distance.hpp"
#include "audit/time_stepping_turn.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "rubsweep/core/scene/build_scene.hpp"

namespace rubsweep::audit {
namespace {

using integrate::run::Outcome;
using integrate::run::TurnReport;
using integrate::run::TurnRequest;

constexpr double clearly = 4;      ///< least error that counts / uncertainty of the time stepping
constexpr double rounding = 1e-6;  ///< errors of the section that no time stepping can resolve
constexpr double undecided = 0.1;  ///< clearances: a larger spread of the time steppings allows no verdict
/// Refinements of the time steps, tried in turn before a result is called wrong.
constexpr std::array refinements{1, 8, 40};

/// Number of steps per turn in which the phase of the stiffest contact changes only little.
long steps_of_turn(const scene::Scene& scene) {
  constexpr double little_rad = 0.1;
  const double mass = scene.structure.mass.diagonal().minCoeff();
  double stiffest = 0;
  for (const scene::Contact& contact : scene.contacts)
    stiffest = std::max(stiffest, contact.stiffness_n_per_m / mass);
  const double turn_rad = std::sqrt(stiffest) * scene.period_s();
  return std::clamp(std::lround(turn_rad / little_rad), 4000L, 60000L);
}

double size_of(const std::vector<double>& section) {
  double largest = 1;
  for (const double value : section) largest = std::max(largest, std::abs(value));
  return largest;
}

/// Distance of a section from the finest of three time steppings, and the largest distance between these.
struct Comparison {
  double error = 0, spread = 0;
  bool stuck = false, together = false;

  Comparison(const scene::Scene& scene, const std::vector<double>& before, const std::vector<double>& after,
             long steps) {
    // The ratios of the step numbers are not simple: otherwise an event half a step late in each would look
    // like agreement.
    const SteppedTurn coarse = time_stepping_turn(scene, before, steps),
                      middle = time_stepping_turn(scene, before, 17 * steps / 10),
                      fine = time_stepping_turn(scene, before, 31 * steps / 10);
    error = section_distance(after, fine.section);
    spread = std::max(section_distance(coarse.section, fine.section),
                      section_distance(middle.section, fine.section));
    stuck = fine.stuck > 0;
    together = fine.together > 0;
  }

  bool agrees(const std::vector<double>& after) const {
    return error <= clearly * spread + rounding * size_of(after);
  }
};

/// Refines the steps until both results agree, or to the largest refinement.
Comparison compared(const scene::Scene& scene, const std::vector<double>& before,
                    const std::vector<double>& after) {
  const long steps = steps_of_turn(scene);
  std::optional<Comparison> found;
  for (const int finer : refinements) {
    found.emplace(scene, before, after, finer * steps);
    if (found->agrees(after)) break;
  }
  return *found;
}

}  // namespace

EventAudit audit_dry_contacts(const RandomCell& random, int turns, int most_checked) {
  EventAudit audit;
  scene::Unbalance unbalance = scene::WhirlRatio{random.whirl_ratio};
  if (random.eccentricity_m) unbalance = scene::Eccentricity{*random.eccentricity_m};
  const scene::Cell cell = scene::build_cell(random.machine, random.speed_hz, unbalance);
  if (!scene::can_run(cell.start)) return audit;
  scene::Scene free = cell.scene;
  free.pulses.clear();
  integrate::run::SolverOptions options;
  options.method = integrate::run::Method::exact;
  integrate::exact::modes::ModeCache modes;
  const integrate::run::Run run = integrate::start(cell.scene, options, modes);
  const double kick_turns = random.machine.kick ? random.machine.kick->duration_s * random.speed_hz : 0;
  TurnReport turn;
  std::vector<double> before;
  long taylor_turns = 0;
  for (int k = 0, checked = 0; k < turns && checked < most_checked; ++k) {
    before = turn.section;
    audit.outcome = run.advance({}, turn);
    if (audit.outcome != Outcome::ok) {
      audit.exact_failed = true;
      return audit;
    }
    const bool pieces = turn.effort.taylor_turns != taylor_turns;
    taylor_turns = turn.effort.taylor_turns;
    if (k < 1 || k < kick_turns || !turn.touched) continue;
    ++checked;
    ++audit.turns;
    ++audit.touched;
    audit.turns_with_pieces += pieces;
    audit.exact_turns += !pieces;
    const Comparison found = compared(free, before, turn.section);
    audit.stuck += found.stuck;
    audit.stuck_together += found.together;
    audit.parted += found.spread > undecided;
    if (found.agrees(turn.section)) continue;
    audit.difference = EventDifference{k + 1, found.error, found.spread, {}};
    return audit;
  }
  return audit;
}

}  // namespace rubsweep::audit
