#include "rubsweep/scene/prepared_machine.hpp"

#include <utility>
#include <vector>

#include "rubsweep/structure/jeffcott.hpp"
#include "rubsweep/structure/kit_assembly.hpp"

namespace rubsweep::scene {

PreparedMachine prepare_machine(const model::Machine& machine) {
  model::validate(machine);
  if (machine.kit) {
    structure::KitAssembly kit = structure::assemble_rotor_kit(machine);
    structure::refuse_unusable(kit.assembly);
    return {machine, std::move(kit.assembly), std::move(kit.reduction)};
  }
  std::vector<std::optional<model::Casing>> casings;
  for (const model::Stop& stop : machine.stops) casings.push_back(stop.casing);
  structure::Assembly assembly = structure::assemble_jeffcott(machine.rotor, casings);
  structure::refuse_unusable(assembly);
  return {machine, std::move(assembly), {}};
}

}  // namespace rubsweep::scene
