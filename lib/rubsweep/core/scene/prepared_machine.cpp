#include "rubsweep/core/scene/prepared_machine.hpp"

#include <map>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "rubsweep/core/contact/friction_bounds.hpp"
#include "rubsweep/core/overloaded.hpp"
#include "rubsweep/core/structure/kit_assembly.hpp"

namespace rubsweep::scene {

/// Structures at single speeds; several threads may use them at once.
class StructuresAtSpeeds {
 public:
  /// Builds the structure of `machine` where the speed is new. Throws ConfigError as kit_of_known_modes.
  const structure::KitAssembly& at(double speed_hz, const model::Machine& machine);

 private:
  std::mutex mutex_;
  std::map<double, std::unique_ptr<const structure::KitAssembly>> known_;
};

namespace {

/// Throws ConfigError for numbers that are not allowed, and for friction that drives the slip.
void refuse_invalid(const model::Machine& machine) {
  model::validate(machine);
  for (std::size_t i = 0; i < machine.stops.size(); ++i)
    contact::refuse_driving(machine.stops[i].friction, "stops." + std::to_string(i) + ".friction");
}

/// Structure of a valid rotor kit whose number of modes is given. Throws ConfigError where the machine is not
/// allowed, or its numbers are too far apart for computing the structure.
structure::KitAssembly kit_of_known_modes(const model::Machine& machine) {
  refuse_invalid(machine);
  structure::KitAssembly kit = structure::assemble_kit_for_speed(machine);
  structure::refuse_unusable(kit.assembly);
  return kit;
}

/// Null for a machine whose supports do not follow tables.
std::shared_ptr<StructuresAtSpeeds> structures_of(const structure::Assembly& assembly) {
  return assembly.tables.empty() ? nullptr : std::make_shared<StructuresAtSpeeds>();
}

}  // namespace

const structure::KitAssembly& StructuresAtSpeeds::at(double speed_hz, const model::Machine& machine) {
  {
    const std::lock_guard lock(mutex_);
    if (const auto found = known_.find(speed_hz); found != known_.end()) return *found->second;
  }
  auto made = std::make_unique<const structure::KitAssembly>(kit_of_known_modes(machine));
  const std::lock_guard lock(mutex_);
  return *known_.try_emplace(speed_hz, std::move(made)).first->second;
}

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

PreparedMachine prepare_with_modes(const model::Machine& machine, int modes) {
  model::Machine with_modes = machine;
  model::kit_of(with_modes)->modes = modes;
  structure::KitAssembly kit = kit_of_known_modes(with_modes);
  std::shared_ptr<StructuresAtSpeeds> at_speeds = structures_of(kit.assembly);
  return {std::move(with_modes), std::move(kit.assembly), std::move(kit.reduction), std::move(at_speeds)};
}

}  // namespace rubsweep::scene
