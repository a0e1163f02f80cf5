#include "rubsweep/scene/prepared_machine.hpp"

#include <utility>
#include <vector>

#include "rubsweep/overloaded.hpp"
#include "rubsweep/scene/structures_at_speeds.hpp"
#include "rubsweep/structure/jeffcott.hpp"
#include "rubsweep/structure/kit_assembly.hpp"

namespace rubsweep::scene {

PreparedMachine prepare_machine(const model::Machine& machine) {
  refuse_invalid(machine);
  PreparedMachine prepared =
      std::visit(overloaded{[&](const model::JeffcottRotor& rotor) -> PreparedMachine {
                              std::vector<std::optional<model::Casing>> casings;
                              for (const model::Stop& stop : machine.stops) casings.push_back(stop.casing);
                              return {machine, structure::assemble_jeffcott(rotor, casings), {}};
                            },
                            [&](const model::RotorKit&) -> PreparedMachine {
                              structure::KitAssembly kit = structure::assemble_rotor_kit(machine);
                              return {machine, std::move(kit.assembly), std::move(kit.reduction)};
                            }},
                 machine.rotor);
  structure::refuse_unusable(prepared.assembly);
  prepared.at_speeds = structures_of(prepared.assembly);
  return prepared;
}

PreparedMachine prepared_at(const PreparedMachine& prepared, double speed_hz) {
  if (!prepared.at_speeds) return prepared;
  model::Machine machine = structure::machine_at(prepared.machine, speed_hz);
  const auto& [assembly, reduction] = prepared.at_speeds->at(speed_hz, machine);
  return {std::move(machine), assembly, reduction};
}

PreparedMachine prepare_other_kick(const PreparedMachine& prepared, const model::Machine& machine) {
  refuse_invalid(machine);
  return {machine, prepared.assembly, prepared.reduction, prepared.at_speeds};
}

}  // namespace rubsweep::scene
