#pragma once

#include <functional>
#include <optional>

#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/maps/sweep/row.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::sweep {

/// Relative change of the kick force that the class and order of a robust cell survive, in both directions.
inline constexpr double robustness_change = 1e-6;

/// Whether a cell of `machine` whose verdict is `row` keeps its class and order when the kick is a little
/// weaker or stronger: false on the boundary between the basins of two motions, and where chaos decides by
/// the last bit which one the run falls into. Empty where no kick was simulated or the run failed. `evaluate`
/// runs the same cell with another machine; it is called at most twice.
std::optional<bool> is_robust(const Row& row, const model::Machine& machine,
                              const std::function<Row(const model::Machine&)>& evaluate);

/// Share of the neighbouring kicks after which the cell keeps its class and order: forces that differ by
/// equal steps up to `neighbours.part`, in both directions. Empty where is_robust is.
std::optional<double> robust_share(const Row& row, const model::Machine& machine,
                                   const Neighbours& neighbours,
                                   const std::function<Row(const model::Machine&)>& evaluate);

}  // namespace rubsweep::sweep
