#pragma once

#include <functional>
#include <optional>

#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/maps/sweep/row.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::sweep {

/// Relative change of the kick's force, in both directions, under which a robust cell keeps its class and
/// order.
inline constexpr double robustness_change = 1e-6;

/// Whether a cell of `machine`, computed as `row`, keeps its class and order when the kick is slightly weaker
/// or stronger. A cell changes on the boundary between the basins of two motions, or where a chaotic
/// transient makes the last bit decide. Empty where no kick was simulated or the run failed. `evaluate` runs
/// the same cell with another machine, at most twice.
std::optional<bool> is_robust(const Row& row, const model::Machine& machine,
                              const std::function<Row(const model::Machine&)>& evaluate);

/// Share of neighbouring kicks for which the cell keeps its class and order. Their forces differ by equal
/// steps up to `neighbours.part`, in both directions. Empty where is_robust would be.
std::optional<double> robust_share(const Row& row, const model::Machine& machine,
                                   const Neighbours& neighbours,
                                   const std::function<Row(const model::Machine&)>& evaluate);

}  // namespace rubsweep::sweep
