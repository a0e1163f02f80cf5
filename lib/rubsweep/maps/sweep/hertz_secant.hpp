#pragma once

#include <functional>
#include <optional>

#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/maps/sweep/row.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::sweep {

/// Whether cells of the study may be run again with other secants of Hertz' line contacts: it allows it, and
/// some stop has such a contact.
bool takes_secants_anew(const Study& study);

/// `machine` with the stiffness of every stop that has it by Hertz taken as the secant at `force_n`, or at
/// its own design force where that is more; a restitution goes on to mean what it says. Empty where a contact
/// is wider than long under it.
std::optional<model::Machine> with_secant_at(const model::Machine& machine, double force_n);

/// The machine that a row was computed with: `force_n` is HertzSecant::force_n of that row, nothing where its
/// secants are those of the configuration.
scene::PreparedMachine with_secant_of_row(const scene::PreparedMachine& prepared,
                                          std::optional<double> force_n);

/// The row of a cell whose secants belong to its forces, of a machine some of whose stops have hertz. `run`
/// evaluates the cell for a machine. While the largest contact force of the measured motion asks for a secant
/// that differs by more than contact::hertz_secant_tolerance from the one that was used, the cell is run
/// again with the secant at that force, at most `most` times. A motion without contact asks for nothing: a
/// rub that dies with the stiffness of its own force is what the row says. Where the last secant still does
/// not fit, the status says `beyond_hertz`.
Row with_hertz_iterations(const model::Machine& machine, int most,
                          const std::function<Row(const model::Machine&)>& run);

}  // namespace rubsweep::sweep
