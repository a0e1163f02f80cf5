#include "rubsweep/scene/structures_at_speeds.hpp"

#include <string>
#include <utility>

#include "rubsweep/contact/friction_bounds.hpp"

namespace rubsweep::scene {

const structure::KitAssembly& StructuresAtSpeeds::at(double speed_hz, const model::Machine& machine) {
  {
    const std::lock_guard lock(mutex_);
    if (const auto found = known_.find(speed_hz); found != known_.end()) return *found->second;
  }
  auto made = std::make_unique<const structure::KitAssembly>(kit_of_known_modes(machine));
  const std::lock_guard lock(mutex_);
  return *known_.try_emplace(speed_hz, std::move(made)).first->second;
}

std::shared_ptr<StructuresAtSpeeds> structures_of(const structure::Assembly& assembly) {
  return assembly.tables.empty() ? nullptr : std::make_shared<StructuresAtSpeeds>();
}

void refuse_invalid(const model::Machine& machine) {
  model::validate(machine);
  for (std::size_t i = 0; i < machine.stops.size(); ++i)
    contact::refuse_driving(machine.stops[i].friction, "stops." + std::to_string(i) + ".friction");
}

structure::KitAssembly kit_of_known_modes(const model::Machine& machine) {
  refuse_invalid(machine);
  structure::KitAssembly kit = structure::assemble_kit_for_speed(machine);
  structure::refuse_unusable(kit.assembly);
  return kit;
}

}  // namespace rubsweep::scene
