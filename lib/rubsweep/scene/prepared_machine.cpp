#include "rubsweep/scene/prepared_machine.hpp"

#include <map>
#include <mutex>
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

class StructuresAtSpeeds {
 public:
  struct Structure {
    structure::Assembly assembly;
    std::optional<structure::Reduction> reduction;
  };

  /// `machine`: what is built where the speed is new.
  const Structure& at(double speed_hz, const model::Machine& machine) {
    {
      const std::lock_guard lock(mutex_);
      if (const auto found = known_.find(speed_hz); found != known_.end()) return *found->second;
    }
    refuse_invalid(machine);
    structure::KitAssembly kit = structure::assemble_kit_for_speed(machine);
    structure::refuse_unusable(kit.assembly);
    // With braces: clang 14 makes no aggregate with parentheses.
    std::unique_ptr<const Structure> made(new Structure{std::move(kit.assembly), std::move(kit.reduction)});
    const std::lock_guard lock(mutex_);
    return *known_.try_emplace(speed_hz, std::move(made)).first->second;
  }

 private:
  std::mutex mutex_;
  std::map<double, std::unique_ptr<const Structure>> known_;
};

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
  if (!prepared.assembly.tables.empty()) prepared.at_speeds = std::make_shared<StructuresAtSpeeds>();
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
