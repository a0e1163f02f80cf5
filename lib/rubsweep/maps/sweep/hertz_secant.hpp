#pragma once

#include <functional>
#include <optional>

#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/maps/sweep/row.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::sweep {

/// Whether cells of the study may be run again with other secants of Hertz' line contacts: the study allows
/// it, and some stop has such a contact.
bool takes_secants_anew(const Study& study);

/// `machine` with new secant stiffnesses at every stop with a Hertz line contact: each secant is taken at
/// `force_n`, or at the stop's design force if that is larger. A restitution keeps its meaning. Empty where
/// this force makes a contact wider than its length.
std::optional<model::Machine> with_secant_at(const model::Machine& machine, double force_n);

/// Machine with which a row was computed. `force_n` is HertzSecant::force_n of that row; empty: secants of
/// the configuration.
scene::PreparedMachine with_secant_of_row(const scene::PreparedMachine& prepared,
                                          std::optional<double> force_n);

/// Runs a cell until its secants agree with its forces, and returns the row. At least one stop of `machine`
/// must have a `hertz` stiffness with a linear law. `run` evaluates the cell for a machine. The cell is run
/// again, at most `most` times, while the secant at its largest measured force differs by more than
/// contact::hertz_secant_tolerance from the secant used. A motion without contact ends the iteration: the row
/// then says that the rub dies out at this stiffness. Where the last secant still does not agree, the status
/// is `beyond_hertz`.
Row with_hertz_iterations(const model::Machine& machine, int most,
                          const std::function<Row(const model::Machine&)>& run);

}  // namespace rubsweep::sweep
