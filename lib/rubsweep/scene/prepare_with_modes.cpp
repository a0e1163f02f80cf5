#include "rubsweep/scene/prepare_with_modes.hpp"

#include <utility>

#include "rubsweep/scene/structures_at_speeds.hpp"

namespace rubsweep::scene {

PreparedMachine prepare_with_modes(const model::Machine& machine, int modes) {
  model::Machine with_modes = machine;
  model::kit_of(with_modes)->modes = modes;
  structure::KitAssembly kit = kit_of_known_modes(with_modes);
  std::shared_ptr<StructuresAtSpeeds> at_speeds = structures_of(kit.assembly);
  return {std::move(with_modes), std::move(kit.assembly), std::move(kit.reduction), std::move(at_speeds)};
}

}  // namespace rubsweep::scene
