#include "rubsweep/config/read_run_config.hpp"

#include "rubsweep/config/base.hpp"
#include "rubsweep/config/diagnostics.hpp"
#include "rubsweep/config/document.hpp"
#include "rubsweep/config/file.hpp"
#include "rubsweep/config/kick.hpp"
#include "rubsweep/config/output.hpp"
#include "rubsweep/config/response.hpp"
#include "rubsweep/config/rotor.hpp"
#include "rubsweep/config/rotor_kit.hpp"
#include "rubsweep/config/section.hpp"
#include "rubsweep/config/solver.hpp"
#include "rubsweep/config/stop.hpp"
#include "rubsweep/config/sweep.hpp"
#include "rubsweep/config/unit_slips.hpp"

namespace rubsweep::config {
namespace {

constexpr std::string_view root_form = "a map with rotor, stops, sweep, output";

/// In an annular stop the tangent turns, along which the surface of a twisting rotor would move.
void refuse_torsion_in_annular_stops(const Value& stops, const model::Machine& machine) {
  const model::RotorKit* kit = model::kit_of(machine);
  if (kit == nullptr || !kit->torsion) return;
  for (const model::Stop& stop : machine.stops) {
    if (std::holds_alternative<model::OneSideGeometry>(stop.geometry)) continue;
    refuse(stops, "has an annular stop beside torsion of the rotor", "one_side stops only, or no torsion");
    return;
  }
}

RunConfig read_sections(const Value& root) {
  Section section(root, root_form);
  section.find(base_key);  // resolved before; still a name that a misspelt key may mean
  RunConfig config;
  sweep::Study& study = config.study;
  if (const auto value = section.require("rotor", "a map")) read_rotor(*value, study.machine);
  const model::RotorKit* kit = model::kit_of(study.machine);
  const auto shaft = kit != nullptr ? std::optional(places(*kit)) : std::nullopt;
  if (const auto value = section.require("stops", "a list of maps")) {
    study.machine.stops = read_stops(*value, shaft);
    refuse_torsion_in_annular_stops(*value, study.machine);
  }
  if (const auto value = section.find("kick")) study.machine.kick = read_kick(*value, shaft);
  section.field("gravity_m_per_s2", study.machine.gravity_m_per_s2, model::not_negative);
  if (const auto value = section.require("sweep", "a map")) study.grid = read_sweep(*value);
  if (const auto value = section.find("solver")) study.solver = read_solver(*value);
  if (const auto value = section.find("response")) read_response(*value, study);
  if (const auto value = section.require("output", "a map")) read_run_output(*value, config);
  section.refuse_unknown_keys();
  return config;
}

}  // namespace

RunConfig read_run_config(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
  return read_run_config_text(read_config_bytes(file), file.string(), overrides);
}

RunConfig read_run_config_text(std::string_view text, const std::string& name,
                               const std::vector<std::string>& overrides) {
  Diagnostics diagnostics(name, overrides);
  const Node root = parse_config(text, name, root_form, overrides, diagnostics);
  RunConfig config = read_sections({root, "", diagnostics});
  if (diagnostics.count() == 0) refuse_unit_slips({root, "", diagnostics});
  diagnostics.throw_if_any();
  return config;
}

}  // namespace rubsweep::config
