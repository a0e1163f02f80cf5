#pragma once

#include "rubsweep/config/printer.hpp"
#include "rubsweep/config/section.hpp"
#include "rubsweep/model/rotor_kit.hpp"

namespace rubsweep::config {

/// The keys of `rotor` beside kind: rotor_kit. Lists of maps: shaft, discs, supports, couplings, sensors;
/// bow, torsion, damping_ratio (a number, or a list by mode), modes (auto or a number), modes_up_to_hz,
/// elements.
model::RotorKit read_rotor_kit(Section& section);
void print_rotor_kit(Printer& printer, const model::RotorKit& kit);

/// Allowed positions along the shaft: between its ends.
model::Range places(const model::RotorKit& kit);

}  // namespace rubsweep::config
