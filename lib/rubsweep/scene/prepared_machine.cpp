#include "rubsweep/scene/prepared_machine.hpp"

#include <string>
#include <utility>
#include <vector>

#include "rubsweep/contact/friction_bounds.hpp"
#include "rubsweep/overloaded.hpp"
#include "rubsweep/structure/jeffcott.hpp"
#include "rubsweep/structure/kit_assembly.hpp"

namespace rubsweep::scene {

namespace {

void refuse_invalid(const model::Machine& machine) {
  model::validate(machine);
  for (std::size_t i = 0; i < machine.stops.size(); ++i)
    contact::refuse_driving(machine.stops[i].friction, "stops." + std::to_string(i) + ".friction");
}

}  // namespace

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
  return prepared;
}

PreparedMachine prepare_other_kick(const PreparedMachine& prepared, const model::Machine& machine) {
  refuse_invalid(machine);
  return {machine, prepared.assembly, prepared.reduction};
}

}  // namespace rubsweep::scene
