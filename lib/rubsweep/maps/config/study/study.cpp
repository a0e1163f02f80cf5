#include "rubsweep/maps/config/study/study.hpp"

#include <algorithm>
#include <optional>
#include <variant>

#include "rubsweep/maps/config/machine/matrix_rotor.hpp"
#include "rubsweep/maps/config/machine/rotor.hpp"
#include "rubsweep/maps/config/machine/rotor_kit.hpp"
#include "rubsweep/maps/config/machine/stop.hpp"
#include "rubsweep/maps/config/study/response.hpp"
#include "rubsweep/maps/config/study/start.hpp"
#include "rubsweep/maps/config/study/study_kind.hpp"
#include "rubsweep/maps/config/study/sweep.hpp"

namespace rubsweep::config::study {
namespace {

/// Friction that sticks would have to hold the twisting surface, which no solver does.
void refuse_dry_friction_beside_torsion(const yaml::Value& stops, const model::Machine& machine) {
  const model::RotorKit* kit = model::kit_of(machine);
  if (kit == nullptr || !kit->torsion) return;
  for (const model::Stop& stop : machine.stops) {
    if (!std::holds_alternative<model::ConstantFriction>(stop.friction)) continue;
    refuse(stops, "has a friction coefficient, which may stick, beside torsion of the rotor",
           "friction by one_way, stribeck or static, or no torsion");
    return;
  }
}

bool is_linear(const model::Stop& stop) { return stop.law.linear(); }

}  // namespace

sweep::Study read_study(yaml::Section& root) {
  sweep::Study study;
  if (const auto value = root.require("rotor", "a map")) machine::read_rotor(*value, study.machine);
  const model::RotorKit* kit = model::kit_of(study.machine);
  const auto shaft = kit != nullptr ? std::optional(machine::places(*kit)) : std::nullopt;
  if (const auto value = root.require("stops", "a list of maps")) {
    study.machine.stops = machine::read_stops(*value, shaft);
    refuse_dry_friction_beside_torsion(*value, study.machine);
  }
  if (const auto value = root.find("kick")) study.machine.kick = read_kick(*value, shaft);
  for (const std::string_view name : {"stops", "kick"}) {
    if (const auto value = root.find(name); value && kit != nullptr)
      machine::refuse_between_nodes(*value, *kit);
  }
  if (const auto value = root.find("start")) {
    study.machine.start = read_start(*value, study.machine.stops);
    if (study.machine.kick) refuse(*value, "is given beside a kick", "one of the two");
  }
  root.field("gravity_m_per_s2", study.machine.gravity_m_per_s2, model::not_negative);
  if (const auto value = root.require("sweep", "a map")) study.grid = read_sweep(*value, study.machine);
  if (const auto value = root.find("study")) read_study_kind(*value, study);
  if (const auto value = root.find("solver")) study.solver = read_solver(*value, study.machine.stops.size());
  if (const auto value = root.find("solver"); value && !integrate::run::knows_curved_laws(study.solver) &&
                                              !std::ranges::all_of(study.machine.stops, is_linear))
    refuse(*value, "knows linear contacts alone by method exact or contact smoothed",
           "method auto or adaptive with contact located beside a law of another kind");
  if (const auto value = root.find("response")) read_response(*value, study);
  if (const auto value = root.find("kick"); value && root.is_sound()) {
    refuse_endless_kick(*value, *study.machine.kick,
                        study.response.max_revolutions / std::ranges::min(study.grid.speed_hz));
  }
  return study;
}

std::vector<keys::Key> study_keys() {
  using namespace keys;
  return {
      must("rotor", machine::rotor_form(), "the rotor"),
      must("stops", machine::stops_form(), "places where it can touch; the whirl ratio refers to the first"),
      may("kick", kick_form(), "half-sine pulse that starts a run", "(none)"),
      may("start", start_form(), "state in which every run begins, instead of a kick", "(none)"),
      may("gravity_m_per_s2", number(model::not_negative),
          "acceleration along -y; clearances count from the unloaded position", "0"),
      must("sweep", sweep_form(), "cells of the map: speeds, unbalances and other axes"),
      newer_key(may("study", study_form(), "what is asked of every cell besides its motion", "(a map)")),
      may("solver", solver_form(), "how motions are computed"),
      may("response", response_form(), "how long runs are and what is looked for in them")};
}

keys::Choice kick_or_start() { return {{{{"kick"}, {}}, {{"start"}, {}}}, true}; }

}  // namespace rubsweep::config::study
