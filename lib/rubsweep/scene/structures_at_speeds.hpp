#pragma once

#include <map>
#include <memory>
#include <mutex>

#include "rubsweep/model/machine.hpp"
#include "rubsweep/scene/prepared_machine.hpp"
#include "rubsweep/structure/kit_assembly.hpp"

namespace rubsweep::scene {

/// Structures of one machine at the speeds that were asked for. For several threads.
class StructuresAtSpeeds {
 public:
  /// `machine`: what is built where the speed is new. Throws ConfigError as kit_of_known_modes.
  const structure::KitAssembly& at(double speed_hz, const model::Machine& machine);

 private:
  std::mutex mutex_;
  std::map<double, std::unique_ptr<const structure::KitAssembly>> known_;
};

/// None of a machine whose supports do not follow tables.
std::shared_ptr<StructuresAtSpeeds> structures_of(const structure::Assembly& assembly);

/// Throws ConfigError for numbers that are not allowed, and for friction that drives.
void refuse_invalid(const model::Machine& machine);

/// Structure of a valid rotor kit that says how many modes it keeps. Throws ConfigError where the machine is
/// not allowed, or its numbers are too far apart for the structure to be computed.
structure::KitAssembly kit_of_known_modes(const model::Machine& machine);

}  // namespace rubsweep::scene
