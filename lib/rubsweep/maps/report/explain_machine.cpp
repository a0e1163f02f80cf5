#include "rubsweep/maps/report/explain_machine.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "rubsweep/core/contact/friction_law.hpp"
#include "rubsweep/core/overloaded.hpp"
#include "rubsweep/core/scene/build_scene.hpp"
#include "rubsweep/core/structure/tabled_support.hpp"
#include "rubsweep/maps/report/explain_rotor.hpp"
#include "rubsweep/maps/report/explain_stop.hpp"

namespace rubsweep::report {
namespace {

std::string explain_kick(const model::Machine& machine) {
  if (model::begins_at_rest(machine.start))
    return "start: at rest in the unloaded position, not kicked, the shaft's mark along +x; unbalance and "
           "weight act from then on\n";
  if (machine.start)
    return "start: in a given state, not kicked; what is not given is that of the quiet whirl\n";
  if (!machine.kick) return "kick: none\n";
  std::string direction =
      machine.kick->angle_deg ? fmt::format(" at {} degrees", *machine.kick->angle_deg) : "";
  if (machine.kick->phase_deg)
    direction += fmt::format(", {} degrees after the smallest gap", *machine.kick->phase_deg);
  return fmt::format(
      "kick: half-sine, {} N for {} s{}\n"
      "  none where the quiet whirl itself reaches a wall (whirl ratio 1 and above): the rotor starts at "
      "rest there\n",
      machine.kick->force_n, machine.kick->duration_s, direction);
}

std::string left_out(const model::Machine& machine) {
  return std::visit(
      overloaded{
          [](const model::JeffcottRotor&) {
            return "left out: torsion and drive (the speed is held constant), axial motion, tilting of "
                   "the disc\n";
          },
          [](const model::RotorKit& kit) {
            return kit.torsion ? "left out: axial motion\n"
                               : "left out: torsion and drive (the speed is held constant), axial motion\n";
          }},
      machine.rotor);
}

}  // namespace

std::string explain_machine(const model::Machine& machine, double speed_hz) {
  const scene::PreparedMachine prepared = scene::prepare_machine(structure::machine_at(machine, speed_hz));
  const scene::Cell cell = scene::build_cell(prepared, speed_hz, scene::WhirlRatio{0});
  const auto coordinates = cell.scene.structure.coordinates();
  const model::RotorKit* kit = model::kit_of(machine);
  std::string text = explain_rotor(prepared, kit != nullptr && model::has_tables(*kit));
  for (std::size_t i = 0; i < machine.stops.size(); ++i) text += explain_stop(prepared, cell, i);
  text += explain_kick(machine);
  text += fmt::format("states: {} ({} coordinates and their rates)\n", 2 * coordinates, coordinates);
  text += left_out(machine);
  if (machine.gravity_m_per_s2 == 0) text += "left out: gravity (gravity_m_per_s2 is 0)\n";
  if (std::ranges::none_of(machine.stops, [](const auto& stop) { return contact::acts(stop.friction); }))
    text += "left out: friction (no stop has any)\n";
  return text;
}

}  // namespace rubsweep::report
