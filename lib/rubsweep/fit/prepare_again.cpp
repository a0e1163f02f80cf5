#include "rubsweep/fit/prepare_again.hpp"

#include <variant>

#include "rubsweep/scene/prepare_with_modes.hpp"

namespace rubsweep::fit {

scene::PreparedMachine prepare_again(const model::Machine& machine, const scene::PreparedMachine& first) {
  if (!std::holds_alternative<model::RotorKit>(machine.rotor) || !first.reduction)
    return scene::prepare_machine(machine);
  return scene::prepare_with_modes(machine, first.reduction->modes);
}

}  // namespace rubsweep::fit
