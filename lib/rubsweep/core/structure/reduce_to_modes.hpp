#pragma once

#include <optional>
#include <vector>

#include "rubsweep/core/structure/reduction.hpp"

namespace rubsweep::structure {

/// Reduction of a kit that says how many modes it keeps, as by reduce() but without the receptance error,
/// whose comparison takes most of the time. One that leaves the number open is reduced by reduce().
Reduction reduce_to_modes(const BeamShaft& shaft, const model::RotorKit& kit,
                          const std::vector<double>& stops_m, const std::vector<double>& sensors_m,
                          std::optional<double> kick_m = {});

}  // namespace rubsweep::structure
