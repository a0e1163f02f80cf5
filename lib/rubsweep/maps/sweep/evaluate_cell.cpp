#include "rubsweep/maps/sweep/evaluate_cell.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "rubsweep/core/contact/friction_law.hpp"
#include "rubsweep/core/contact/hertz_line.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/core/overloaded.hpp"
#include "rubsweep/maps/sweep/hertz_secant.hpp"
#include "rubsweep/maps/sweep/robustness.hpp"
#include "rubsweep/maps/sweep/study_warnings.hpp"

namespace rubsweep::sweep {
namespace {

/// Whether a force exceeds the range of some stop whose stiffness is the secant of a Hertz line contact. All
/// stops are tested, although the force acts on only one, since the status only marks a doubt.
bool beyond_hertz(const model::Machine& machine, double force_n) {
  return std::ranges::any_of(machine.stops, [force_n](const model::Stop& stop) {
    return stop.by_hertz_secant() && force_n > contact::hertz_force_limit_n(*stop.hertz);
  });
}

/// Flags a motion that is too large for the model.
void flag_model_limits(Row& row, const model::Machine& machine, double clearance_m) {
  if (!row.measures) return;
  row.peak_over_clearance = row.measures->contact.peak_displacement_m / clearance_m;
  if (beyond_hertz(machine, row.measures->contact.peak_contact_force_n)) add_status(row, "beyond_hertz");
}

/// Marks a row as failed where a measured number is not finite.
void refuse_what_is_not_finite(Row& row) {
  if (!row.measures) return;
  if (std::isfinite(row.peak_over_clearance.value_or(0)) && response::motion::is_finite(*row.measures))
    return;
  row.motion_class = response::motion::MotionClass::failed;
  row.order.reset();
  row.proof.reset();
  row.measures.reset();
  row.peak_over_clearance.reset();
  add_status(row, integrate::run::to_string(integrate::run::Outcome::non_finite));
}

/// Flags a run that ended before its kick did: it shows the kick, not the motion after it.
void doubt_unfinished_kick(Row& row, const scene::Scene& scene) {
  const double run_s = static_cast<double>(row.revolutions) * scene.period_s();
  const bool over = std::ranges::all_of(scene.pulses, [&](const scene::Pulse& pulse) {
    return pulse.force_n == 0 || pulse.duration_s - pulse.elapsed_s <= run_s;
  });
  if (!over && row.measures) add_status(row, "kick_unfinished");
}

void fill(Row& row, const response::SettledRun& run) {
  row.motion_class = run.motion.motion_class;
  row.order = run.motion.order;
  row.proof = run.proof;
  row.floquet_modulus = run.floquet_modulus;
  if (run.motion.exponent) row.lyapunov_per_revolution = run.motion.exponent->per_revolution;
  row.survival = run.survival;
  row.revolutions = run.revolutions;
  row.last_contact_revolution = run.last_contact_revolution;
  if (run.outcome == integrate::run::Outcome::ok) {
    row.measures = run.motion.measures;
  } else {
    add_status(row, integrate::run::to_string(run.outcome));
  }
  if (run.motion.status != response::motion::MotionStatus::ok) add_status(row, to_string(run.motion.status));
  if (run.slip_reversed) add_status(row, "slip_reversal");
  if (run.rotor_unstable) add_status(row, unstable_rotor);
}

Row not_allowed(const scene::Place& place) {
  Row row;
  row.speed_hz = place.speed_hz;
  row.whirl_ratio = row.eccentricity_m = std::numeric_limits<double>::quiet_NaN();
  std::visit(overloaded{[&](const scene::WhirlRatio& ratio) { row.whirl_ratio = ratio.value; },
                        [&](const scene::Eccentricity& given) { row.eccentricity_m = given.value_m; }},
             place.unbalance);
  row.status = "not_allowed";
  return row;
}

/// Machine with its supports at a speed; empty where they do not hold the shaft at this speed.
std::optional<scene::PreparedMachine> with_supports_at(const scene::PreparedMachine& prepared,
                                                       double speed_hz) {
  try {
    return scene::prepared_at(prepared, speed_hz);
  } catch (const ConfigError&) {
    return std::nullopt;
  }
}

/// Row of a cell at a place, computed with the contact stiffnesses of `prepared`.
Row evaluate_as_it_is(const Study& study, const scene::PreparedMachine& prepared, const scene::Place& place,
                      response::motion::Workspace& workspace) {
  const scene::Cell start = scene::build_cell(prepared, place.speed_hz, place.unbalance);
  if (!scene::can_run(start.start)) return row_of(start, place.speed_hz, prepared.machine, nullptr);
  const response::SettledRun run = response::settle(start, study.solver, study.response, workspace);
  return row_of(start, place.speed_hz, prepared.machine, &run);
}

/// Row of a cell at a place, for a prepared machine that may differ from the study's.
Row evaluate(const Study& study, const scene::PreparedMachine& prepared, const scene::Place& place,
             response::motion::Workspace& workspace) {
  if (prepared.at_speeds) {
    const auto there = with_supports_at(prepared, place.speed_hz);
    return there ? evaluate(study, *there, place, workspace) : not_allowed(place);
  }
  if (!takes_secants_anew(study)) return evaluate_as_it_is(study, prepared, place, workspace);
  return with_hertz_iterations(prepared.machine, study.hertz_iterations, [&](const model::Machine& machine) {
    // The structure is reused, since only stiffnesses of contacts differ.
    return evaluate_as_it_is(study, {machine, prepared.assembly, prepared.reduction}, place, workspace);
  });
}

/// Row of a cell at a place, including the further runs for robustness.
Row evaluate_place(const Study& study, const scene::PreparedMachine& prepared, const scene::Place& place,
                   response::motion::Workspace& workspace) {
  Row row = evaluate(study, prepared, place, workspace);
  const auto with_kick_of = [&](const model::Machine& machine) {
    // The structure is reused, since only the kick differs.
    return evaluate(study, {machine, prepared.assembly, prepared.reduction, prepared.at_speeds}, place,
                    workspace);
  };
  if (study.robustness == Robustness::on) row.robust = is_robust(row, study.machine, with_kick_of);
  if (study.robustness == Robustness::probability) {
    row.robust_share = robust_share(row, study.machine, study.neighbours, with_kick_of);
    if (row.robust_share) row.robust = *row.robust_share == 1;
  }
  return row;
}

/// A study, and its machine prepared.
struct Varied {
  Study study;
  scene::PreparedMachine prepared;
};

bool of_kick_alone(const KeyValue& key) {
  return model::is_of_kick(key.key) && !key.key.ends_with(".position_m");
}

/// Study with new numbers under `keys`, and its machine. `others`: those of the keys by which the study
/// differs from `prepared`. Empty where the numbers are not allowed together, although each of them is.
std::optional<Varied> vary(const Study& study, std::span<const KeyValue> keys,
                           const scene::PreparedMachine& prepared, std::span<const KeyValue> others) {
  try {
    Study varied = study.with_keys(keys);
    scene::PreparedMachine machine = std::ranges::all_of(others, of_kick_alone)
                                         ? scene::prepare_other_kick(prepared, varied.machine)
                                         : scene::prepare_machine(varied.machine);
    return Varied{std::move(varied), std::move(machine)};
  } catch (const ConfigError&) {
    return std::nullopt;
  }
}

/// Whether varying these keys can change the cell: a kick has no effect where the quiet motion itself reaches
/// a wall.
bool may_be_varied(const Row& row, std::span<const KeyValue> keys) {
  const bool of_kick =
      std::ranges::all_of(keys, [](const KeyValue& key) { return model::is_of_kick(key.key); });
  return row.start && (*row.start != RunStart::contact || !of_kick);
}

std::vector<KeyValue> with(std::vector<KeyValue> keys, std::vector<KeyValue> others) {
  for (KeyValue& key : others) keys.push_back(std::move(key));
  return keys;
}

Probe probe_of(const Row& row) {
  return {response::motion::row_of(row.motion_class).rubs,
          row.motion_class == response::motion::MotionClass::failed, class_and_order(row)};
}

}  // namespace

Row row_of(const scene::Cell& cell, double speed_hz, const model::Machine& machine,
           const response::SettledRun* run) {
  Row row;
  row.speed_hz = speed_hz;
  row.whirl_ratio = cell.whirl_ratio;
  row.eccentricity_m = cell.eccentricity_m;
  if (cell.start == scene::Start::unreachable) {
    row.status = "unreachable";
    return row;
  }
  if (cell.start == scene::Start::initial_contact) {
    row.motion_class = response::motion::MotionClass::initial_contact;
    return row;
  }
  row.start = machine.start                         ? RunStart::state
              : cell.start == scene::Start::contact ? RunStart::contact
              : !cell.scene.pulses.empty()          ? RunStart::kick
                                                    : RunStart::quiet;
  if (run == nullptr) return row;
  fill(row, *run);
  flag_model_limits(row, machine, cell.scene.length_scale_m);
  doubt_unfinished_kick(row, cell.scene);
  refuse_what_is_not_finite(row);
  return row;
}

Row evaluate_cell(const Study& study, std::size_t cell, response::motion::Workspace& workspace) {
  return evaluate_cell(study, scene::prepare_machine(study.machine), cell, workspace);
}

Row evaluate_cell(const Study& study, const scene::PreparedMachine& prepared, std::size_t cell,
                  response::motion::Workspace& workspace) {
  const scene::Place place = place_of(study.grid, cell);
  const std::vector<KeyValue> keys = key_values(study.grid, cell);
  std::optional<Varied> own;  // study and machine of a cell with axes over keys
  if (!keys.empty()) own = vary(study, keys, prepared, keys);
  Row row = keys.empty() ? evaluate_place(study, prepared, place, workspace)
            : own        ? evaluate_place(own->study, own->prepared, place, workspace)
                         : not_allowed(place);
  for (const KeyValue& key : keys) row.key_values.push_back(key.value);
  if (study.grid.refinement) row.refinement_level = refinement_level(study.grid, cell);
  const auto run = [&](const std::vector<KeyValue>& others) {
    const auto varied = vary(study, with(keys, others), own ? own->prepared : prepared, others);
    return varied ? evaluate(varied->study, varied->prepared, place, workspace) : not_allowed(place);
  };
  if (study.threshold && may_be_varied(row, keys_at(study.threshold->axis, 1))) {
    row.threshold = find_threshold(
        *study.threshold, [&](double value) { return probe_of(run(keys_at(study.threshold->axis, value))); });
  }
  if (study.basin && may_be_varied(row, draw(*study.basin, 0))) {
    row.basins = sample_basins(
        *study.basin, [&](const std::vector<KeyValue>& drawn) { return sampled_motion(run(drawn)); });
  }
  return row;
}

}  // namespace rubsweep::sweep
