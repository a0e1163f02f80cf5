#include "rubsweep/fit/prepare_again.hpp"

#include <algorithm>
#include <variant>

#include "rubsweep/scene/prepare_with_modes.hpp"

namespace rubsweep::fit {

scene::PreparedMachine prepare_again(const model::Machine& machine, const scene::PreparedMachine& first) {
  if (!std::holds_alternative<model::RotorKit>(machine.rotor) || !first.reduction)
    return scene::prepare_machine(machine);
  const auto& numbers = first.reduction->mode_number;
  return scene::prepare_with_modes(machine, static_cast<int>(std::max(numbers[0].size(), numbers[1].size())));
}

}  // namespace rubsweep::fit
