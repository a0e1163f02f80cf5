#include "rubsweep/fit/prepare_again.hpp"

#include <algorithm>
#include <utility>
#include <variant>

#include "rubsweep/structure/kit_assembly.hpp"

namespace rubsweep::fit {

scene::PreparedMachine prepare_again(const model::Machine& machine, const scene::PreparedMachine& first) {
  if (!std::holds_alternative<model::RotorKit>(machine.rotor) || !first.reduction)
    return scene::prepare_machine(machine);
  model::validate(machine);
  model::Machine with_modes = machine;
  const auto& numbers = first.reduction->mode_number;
  std::get<model::RotorKit>(with_modes.rotor).modes =
      static_cast<int>(std::max(numbers[0].size(), numbers[1].size()));
  structure::KitAssembly kit = structure::assemble_kit_for_speed(with_modes);
  structure::refuse_unusable(kit.assembly);
  return {machine, std::move(kit.assembly), std::move(kit.reduction)};
}

}  // namespace rubsweep::fit
