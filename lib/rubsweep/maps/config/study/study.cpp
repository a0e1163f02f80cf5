#include "rubsweep/maps/config/study/study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "rubsweep/core/integrate/exact/modes/mode_cache.hpp"
#include "rubsweep/maps/config/keys/table.hpp"
#include "rubsweep/maps/config/machine/matrix_rotor.hpp"
#include "rubsweep/maps/config/machine/rotor.hpp"
#include "rubsweep/maps/config/machine/rotor_kit.hpp"
#include "rubsweep/maps/config/machine/stop.hpp"
#include "rubsweep/maps/config/study/sweep.hpp"

namespace rubsweep::config::study {
namespace {

using integrate::run::ContactHandling;
using integrate::run::Method;
using integrate::run::SolverOptions;

/// Whether a key is allowed only with robustness: probability.
bool is_of_neighbours(std::string_view name) { return name.starts_with("robustness_"); }

void refuse_contradictions(const yaml::Section& section, const response::motion::ResponseOptions& options) {
  if (options.max_revolutions < 2 * options.window_revolutions) {
    section.refuse_together("max_revolutions", {"max_revolutions", "window_revolutions"},
                            fmt::format("{} is less than two windows", options.max_revolutions),
                            fmt::format(">= {} = 2 window_revolutions", 2 * options.window_revolutions));
  }
  if (options.samples_per_revolution < 4 * options.max_order) {
    section.refuse_together("samples_per_revolution", {"samples_per_revolution", "max_order"},
                            fmt::format("{} does not resolve max_order", options.samples_per_revolution),
                            fmt::format(">= {} = 4 max_order", 4 * options.max_order));
  }
  if (2 * options.max_order > options.window_revolutions) {
    section.refuse_together("max_order", {"max_order", "window_revolutions"},
                            fmt::format("{} is more than half a window", options.max_order),
                            fmt::format("<= {} = window_revolutions / 2", options.window_revolutions / 2));
  }
}

/// Reads `response`. Every key is optional, with the defaults of the structs. The longest run must hold two
/// windows, a window two turns of the largest order, and the shortest period of a window four samples.
void read_response(const yaml::Value& value, sweep::Study& study) {
  yaml::Section section(value);
  read_fields(section, study.response);
  sweep::Study::visit_fields(study, [&](std::string_view name, auto& field, const auto& key) {
    section.field(name, field, key);
    if (is_of_neighbours(name) && study.robustness != sweep::Robustness::probability && section.find(name))
      section.refuse(name, "says nothing without robustness: probability", "no such key");
  });
  if (section.is_sound()) refuse_contradictions(section, study.response);
}

keys::Form response_form() {
  std::vector<keys::Key> of_study = keys::keys_of<sweep::Study>();
  for (keys::Key& key : of_study) {
    if (is_of_neighbours(key.name)) key.when = {"robustness", {"probability"}};
  }
  return keys::map_of(
      keys::joined({keys::keys_of<response::motion::ResponseOptions>(), std::move(of_study)}));
}

void print_response(yaml::Printer& printer, const sweep::Study& study) {
  printer.open("response");
  print_fields(printer, study.response);
  // Printed only where they have an effect, so that the configurations of other maps do not change.
  sweep::Study::visit_fields(study, [&](std::string_view name, const auto& field, const auto& key) {
    if (is_of_neighbours(name) && study.robustness != sweep::Robustness::probability) return;
    if (name != "hertz_iterations" || study.hertz_iterations > 0) printer.field(name, field, key);
  });
  printer.close();
}

/// Reads `solver`. The exact solver is refused where the machine has more stops than it can handle.
SolverOptions read_solver(const yaml::Value& value, std::size_t stops) {
  yaml::Section section(value);
  SolverOptions solver;
  read_fields(section, solver);
  if (solver.method == Method::exact && solver.contact == ContactHandling::smoothed) {
    section.refuse_together("contact", {"method", "contact"},
                            "'smoothed' is a law that the exact solver does not know",
                            "located, or method adaptive");
  }
  constexpr std::size_t most = integrate::exact::modes::most_exact_contacts;
  if (solver.method == Method::exact && stops > most) {
    section.refuse("method", fmt::format("is exact beside {} stops", stops),
                   fmt::format("auto or adaptive, or at most {} stops", most));
  }
  return solver;
}

keys::Form solver_form() { return keys::map_of(keys::keys_of<SolverOptions>()); }

/// Reads `kick`, which has a position_m for a rotor kit; `places` is its allowed range along the shaft, in m.
model::Kick read_kick(const yaml::Value& value, const std::optional<model::Range>& places) {
  yaml::Section section(value);
  model::Kick kick;
  read_fields(section, kick);
  if (places) section.field("position_m", kick.position_m, *places);
  return kick;
}

keys::Form kick_form() {
  using namespace keys;
  return map_of(joined({keys_of<model::Kick>(),
                        {may("position_m", number(model::not_negative),
                             "place along the shaft, of a rotor kit only", "(first stop)")}}));
}

/// Refuses a kick that lasts as long as a run or longer. `longest_run_s` is the duration at the slowest
/// speed.
void refuse_endless_kick(const yaml::Value& value, const model::Kick& kick, double longest_run_s) {
  if (kick.force_n == 0 || kick.duration_s < longest_run_s) return;
  yaml::Section section(value);
  section.allow_unknown_keys();
  section.refuse("duration_s",
                 fmt::format("{} s are no shorter than a run, {:.4g} s", kick.duration_s, longest_run_s),
                 "less than response.max_revolutions / speed");
}

void print_kick(yaml::Printer& printer, std::string_view name, const model::Kick& kick) {
  printer.open(name);
  print_fields(printer, kick);
  printer.field("position_m", kick.position_m, model::any_finite);
  printer.close();
}

/// Refuses sticking friction together with torsion: no solver can compute a stop that holds a twisting
/// surface.
void refuse_dry_friction_beside_torsion(const yaml::Value& stops, const model::Machine& machine) {
  const model::RotorKit* kit = model::kit_of(machine);
  if (kit == nullptr || !kit->torsion) return;
  for (const model::Stop& stop : machine.stops) {
    if (!model::may_stick(stop.friction)) continue;
    refuse(stops, "has a friction coefficient, which may stick, beside torsion of the rotor",
           "friction by one_way, stribeck or static, or no torsion");
    return;
  }
}

/// Refuses static friction with smoothed contact: a smoothed law is one smooth curve through slip 0 and never
/// sticks.
void refuse_static_friction_smoothed(const yaml::Value& solver, const sweep::Study& study) {
  if (study.solver.contact != integrate::run::ContactHandling::smoothed) return;
  const auto holds = [](const model::Stop& stop) { return model::holding_and_sliding(stop.friction)[0] > 0; };
  if (std::ranges::any_of(study.machine.stops, holds))
    refuse(solver, "smooths the contact, beside static friction of a stop, which only holds without",
           "contact: located, or friction without static");
}

void refuse_curved_laws(const yaml::Value& solver, const sweep::Study& study) {
  const auto is_linear = [](const model::Stop& stop) { return stop.law.linear(); };
  if (!integrate::run::knows_curved_laws(study.solver) &&
      !std::ranges::all_of(study.machine.stops, is_linear))
    refuse(solver, "knows linear contacts alone by method exact or contact smoothed",
           "method auto or adaptive with contact located beside a law of another kind");
}

}  // namespace

sweep::Study read_study(yaml::Section& root) {
  sweep::Study study;
  if (const auto value = root.require("rotor", "a map")) machine::read_rotor(*value, study.machine);
  const model::RotorKit* kit = model::kit_of(study.machine);
  const auto shaft = kit != nullptr ? std::optional(machine::places(*kit)) : std::nullopt;
  if (const auto value = root.require("stops", "a list of maps")) {
    study.machine.stops = machine::read_stops(*value, shaft, study.stop_names);
    refuse_dry_friction_beside_torsion(*value, study.machine);
  }
  const auto refuse_between_nodes = [&](std::string_view name) {
    if (const auto value = root.find(name); value && kit != nullptr)
      machine::refuse_between_nodes(*value, *kit);
  };
  refuse_between_nodes("stops");
  model::Machine::visit_kicks(study.machine, [&](std::string_view name, auto& kick, const auto&...) {
    if (const auto value = root.find(name)) {
      kick = read_kick(*value, shaft);
      if (!study.machine.kick) refuse(*value, "is given without kick", "beside kick");
    }
    refuse_between_nodes(name);
  });
  if (const auto value = root.find("start")) {
    study.machine.start = read_start(*value, study.machine.stops);
    if (study.machine.kick && !model::begins_at_rest(study.machine.start))
      refuse(*value, "is given beside a kick", "one of the two, or rest");
  }
  root.field("gravity_m_per_s2", study.machine.gravity_m_per_s2, model::not_negative);
  if (const auto value = root.require("sweep", "a map")) study.grid = read_sweep(*value, study.machine);
  if (const auto value = root.find("study")) read_study_kind(*value, study);
  if (const auto value = root.find("solver")) {
    study.solver = read_solver(*value, study.machine.stops.size());
    refuse_static_friction_smoothed(*value, study);
    refuse_curved_laws(*value, study);
  }
  if (const auto value = root.find("response")) read_response(*value, study);
  model::for_each_kick(study.machine, [&](auto& kick, auto name) {
    if (root.is_sound())
      refuse_endless_kick(*root.find(name), kick,
                          study.response.max_revolutions / std::ranges::min(study.grid.speed_hz));
  });
  return study;
}

std::vector<keys::Key> study_keys() {
  using namespace keys;
  std::vector<Key> kicks;
  const model::Machine any{};
  model::Machine::visit_kicks(
      any, [&](std::string_view name, const auto&, std::string_view meaning, std::string_view since) {
        kicks.push_back(may(std::string(name), kick_form(), std::string(meaning), "(none)"));
        kicks.back().since = since;
      });
  return joined(
      {{must("rotor", machine::rotor_form(), "the rotor"),
        must("stops", machine::stops_form(),
             "places where it can touch; the whirl ratio refers to the first")},
       std::move(kicks),
       {may("start", start_form(),
            "state in which every run begins, instead of a kick; a kick may stand beside rest", "(none)"),
        may("gravity_m_per_s2", number(model::not_negative),
            "acceleration along -y; clearances count from the unloaded position", "0"),
        must("sweep", sweep_form(), "cells of the map: speeds, unbalances and other axes"),
        newer_key(may("study", study_form(), "what is asked of every cell besides its motion", "(a map)")),
        may("solver", solver_form(), "how motions are computed"),
        may("response", response_form(), "how long runs are and what is looked for in them")}});
}

keys::Choice kick_or_start() {
  keys::Way kicked;
  const model::Machine any{};
  model::Machine::visit_kicks(any, [&](std::string_view name, const auto&...) {
    (kicked.required.empty() ? kicked.required : kicked.optional).emplace_back(name);
  });
  kicked.optional.emplace_back("start");
  return {{std::move(kicked), {{"start"}, {}}}, true, "start"};
}

void print_study(yaml::Printer& printer, const sweep::Study& study, AxisPrint how,
                 machine::MatrixPrint matrices) {
  machine::print_rotor(printer, study.machine, matrices);
  machine::print_stops(printer, study.machine.stops, study.stop_names);
  model::for_each_kick(study.machine, [&](auto& kick, auto name) { print_kick(printer, name, kick); });
  if (study.machine.start) print_start(printer, *study.machine.start);
  printer.number("gravity_m_per_s2", study.machine.gravity_m_per_s2);
  print_sweep(printer, study.grid, how);
  print_study_kind(printer, study, how);
  print_map(printer, "solver", study.solver);
  print_response(printer, study);
}

}  // namespace rubsweep::config::study
