#include "rubsweep/maps/report/describe_modes.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rubsweep::report {

std::string describe_many_modes(const scene::PreparedMachine& prepared) {
  // The exact solver's work at every step grows with them.
  constexpr std::size_t many = 12;
  const model::RotorKit* kit = model::kit_of(prepared.machine);
  if (kit == nullptr || !prepared.reduction || !prepared.reduction->automatic) return "";
  const auto& numbers = prepared.reduction->mode_number;
  const std::size_t most = std::max(numbers[0].size(), numbers[1].size());
  if (most <= many) return "";
  return fmt::format(
      "modes: auto keeps {} modes a plane, and a cell takes longer with each; a smaller rotor.modes_up_to_hz "
      "(now {}) "
      "or a number as rotor.modes keeps fewer",
      most, kit->modes_up_to_hz);
}

}  // namespace rubsweep::report
