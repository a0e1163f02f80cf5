#include "explain/explain_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "explain/explain_machine.hpp"
#include "explain/explain_rotor.hpp"
#include "rubsweep/core/contact/friction_law.hpp"
#include "rubsweep/core/contact/wall.hpp"
#include "rubsweep/core/integrate/adaptive/stepper_table.hpp"
#include "rubsweep/core/integrate/flight_run.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "rubsweep/core/model/speed_text.hpp"
#include "rubsweep/core/scene/build_scene.hpp"
#include "rubsweep/maps/report/describe_grid.hpp"
#include "rubsweep/maps/sweep/study_warnings.hpp"

namespace rubsweep::apps {
namespace {

constexpr const char* located = "contact: located, every change of contact mode is found to rounding\n";

bool friction_depends_on_slip(const model::Machine& machine) {
  return std::ranges::any_of(machine.stops,
                             [](const model::Stop& stop) { return contact::depends_on_slip(stop.friction); });
}

/// The stepper that `stepper: auto` selects for this machine, and the reason.
std::string explain_automatic(const sweep::Study& study) {
  if (!friction_depends_on_slip(study.machine))
    return "stepper auto: dopri5 throughout, as no friction depends on the slip\n";
  return fmt::format(
      "stepper auto: {} for steps that start in stiff friction, where friction alone would change the slip "
      "{:.3g} times faster than the contact spring does: slip near zero (backward rolling, sticking) under a "
      "steep tanh; dopri5 elsewhere, being several times faster per step there\n",
      integrate::adaptive::row_of(integrate::run::Stepper::rosenbrock4).description,
      integrate::run::stiff_friction_ratio(study.solver.relative_tolerance));
}

/// Explains the turns for which the exact solver has no closed form.
std::string explain_beyond(const model::Machine& machine) {
  std::string_view curved;
  bool unsaturated = false;
  for (const model::Stop& stop : machine.stops) {
    if (!contact::linear(contact::wall_of(stop.geometry))) curved = model::name_of(stop.geometry);
    unsaturated = unsaturated || !contact::saturated_friction(stop.friction);
  }
  if (!curved.empty()) return fmt::format("turns that touch the {} stop", curved);
  if (unsaturated) return "turns with contact (friction has a viscous part or never saturates)";
  return "turns whose friction is not saturated";
}

scene::Scene slowest_scene(const sweep::Study& study) {
  return scene::build_cell(study.machine, std::ranges::min(study.grid.speed_hz), scene::Eccentricity{0})
      .scene;
}

bool exact(const sweep::Study& study) {
  return integrate::solver_of(slowest_scene(study), study.solver) == integrate::Solver::exact;
}

/// Whether flights between contacts have closed forms though contacts have none.
bool flies(const sweep::Study& study) { return integrate::may_fly(slowest_scene(study), study.solver); }

std::string explain_solver(const sweep::Study& study) {
  const integrate::run::SolverOptions& solver = study.solver;
  const bool chosen = solver.method == integrate::run::Method::automatic;
  const bool smoothed = solver.contact == integrate::run::ContactHandling::smoothed;
  std::string text;
  if (exact(study)) {
    text = fmt::format("solver: exact{}, closed forms between mode switches, which certified steps find; {} ",
                       chosen ? " (auto: wherever it applies)" : "", explain_beyond(study.machine));
    if (!smoothed && solver.stepper == integrate::run::Stepper::automatic)
      return text + "in\n  Taylor pieces, to rounding, too\n" + located;
    text += "by the\n  adaptive one: ";
  } else {
    const bool curved =
        !std::ranges::all_of(study.machine.stops, [](const model::Stop& stop) { return stop.law.linear(); });
    const std::string_view why =
        flies(study) ? " (auto: contacts are not linear; closed forms between them)"
        : curved     ? " (auto: the exact one knows linear contacts alone)"
                     : " (auto: the exact one takes no smoothed contact and at most six stops)";
    text = fmt::format("solver: adaptive{}, ", chosen ? why : "");
  }
  text += fmt::format("{}, relative tolerance {}\n", integrate::adaptive::row_of(solver.stepper).description,
                      solver.relative_tolerance);
  if (solver.stepper == integrate::run::Stepper::automatic) text += explain_automatic(study);
  if (smoothed) {
    return text +
           fmt::format("contact: smoothed over {} m of penetration, no event location\n", solver.smoothing_m);
  }
  return text + located;
}

std::string explain_axis(const sweep::KeyAxis& axis) {
  const auto [least, most] = std::minmax_element(axis.values.begin(), axis.values.end());
  std::string keys;
  for (std::size_t i = 0; i < axis.keys.size(); ++i) {
    keys += (i > 0 ? ", " : "") + axis.keys[i];
    if (axis.factors[i] != 1) keys += fmt::format(" (times {})", axis.factors[i]);
  }
  return fmt::format("{} values of {} from {} to {}{}\n", axis.values.size(), keys, *least, *most,
                     axis.spacing && axis.spacing->logarithmic ? ", logarithmic" : "");
}

/// "31 speeds from 3000 to 12000 rpm (50 to 200 Hz), logarithmic"; one value by itself.
std::string explain_place_axis(const std::vector<double>& values, const sweep::WrittenAxis& written,
                               std::string_view one, std::string_view many, std::string_view si_unit) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const auto span = [&](std::string_view from, std::string_view to) {
    return values.size() == 1 ? std::string(from) : fmt::format("{} to {}", from, to);
  };
  std::string text =
      values.size() == 1 ? std::string(one) + " " : fmt::format("{} {} from ", values.size(), many);
  if (written.is_si()) {
    text += span(fmt::format("{}", *least), fmt::format("{}", *most)) + std::string(si_unit);
    if (si_unit == " Hz") {
      text += fmt::format(" ({} rpm)", span(fmt::format("{:.6g}", model::rpm_per_hz * *least),
                                            fmt::format("{:.6g}", model::rpm_per_hz * *most)));
    }
  } else {
    text +=
        fmt::format("{} {} ({}{})", span(sweep::in_units(written, *least), sweep::in_units(written, *most)),
                    written.unit, span(fmt::format("{:.6g}", *least), fmt::format("{:.6g}", *most)), si_unit);
  }
  return written.spacing && written.spacing->logarithmic ? text + ", logarithmic" : text;
}

std::string explain_sweep(const sweep::Grid& grid) {
  const bool by_ratio = grid.measure == sweep::UnbalanceMeasure::whirl_ratio;
  const bool in_metres = grid.written_unbalance.is_si();
  return fmt::format("sweep: {} cells, {}, {}\n", sweep::cell_count(grid),
                     explain_place_axis(grid.speed_hz, grid.written_speed, "speed", "speeds", " Hz"),
                     explain_place_axis(grid.unbalance, grid.written_unbalance,
                                        by_ratio    ? "whirl ratio"
                                        : in_metres ? "eccentricity"
                                                    : "unbalance",
                                        by_ratio    ? "whirl ratios"
                                        : in_metres ? "eccentricities"
                                                    : "unbalances",
                                        by_ratio    ? ""
                                        : in_metres ? " m"
                                                    : " m of eccentricity"));
}

}  // namespace

std::string explain_study(const sweep::Study& study) {
  const auto [slowest, fastest] = std::minmax_element(study.grid.speed_hz.begin(), study.grid.speed_hz.end());
  std::string text = explain_machine(study.machine, *slowest, study.stop_names);
  const scene::PreparedMachine prepared = scene::prepare_machine(study.machine);
  text += explain_tables(study.machine, study.grid.speed_hz) + describe_sparse_tables(study.machine);
  text += sweep::where_rotor_is_unstable(study, prepared) + sweep::why_torsion_is_idle(prepared, *slowest) +
          sweep::why_walls_stay_untouched(study, prepared) + explain_solver(study);
  text += fmt::format(
      "a cell ends when rest {}is proven, else after {} revolutions, by its last two windows of {}\n",
      study.response.floquet_proof ? "or a stable orbit " : "", study.response.max_revolutions,
      study.response.window_revolutions);
  text += explain_sweep(study.grid);
  for (const sweep::KeyAxis& axis : study.grid.axes) text += "  and " + explain_axis(axis);
  if (study.threshold) {
    text += fmt::format(
        "threshold: in each cell, after which of {}  rub goes on; where it begins or ends between two of "
        "them to {} of it\n",
        explain_axis(study.threshold->axis), study.threshold->tolerance);
  }
  if (study.basin) {
    text += fmt::format("basins: in each cell, where {} starts lead, drawn over", study.basin->samples);
    for (const sweep::DrawnKey& drawn : study.basin->over)
      text += fmt::format(" {} from {} to {}", drawn.key, drawn.from, drawn.to);
    text += "\n";
  }
  if (study.grid.refinement) {
    text += fmt::format("refined: from every {}th cell on, only where labels differ; {} is not missed\n",
                        1 << study.grid.refinement->levels, report::describe_island_bound(study.grid));
  }
  return text;
}

}  // namespace rubsweep::apps
