#pragma once

#include <string>
#include <vector>

#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/core/model/rotor_kit.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"

namespace rubsweep::report {

/// Lines about the rotor of a machine for `--explain`: its coordinates, what of it is reduced and left out.
/// `by_tables`: supports of the machine follow the speed, and `prepared` is the machine at one of its speeds.
std::string explain_rotor(const scene::PreparedMachine& prepared, bool by_tables);

/// Lines about the matrices of a kit: their size, mass and nodes, and what of them is symmetric and what is
/// not.
std::string explain_matrices(const model::RotorKit& kit);

/// For people: the coefficients of every support that follows a table, at the slowest, a middle and the
/// fastest of these speeds, which the tables must reach. Empty where there is no table.
std::string explain_tables(const model::Machine& machine, std::vector<double> speeds_hz);

/// One line for every table with so few points that the curve between them is left to chance; empty where
/// there is none.
std::string describe_sparse_tables(const model::Machine& machine);

/// Advice on the key to lower where `modes: auto` keeps so many modes of a rotor kit that cells become slow,
/// one line without its end; empty where it does not.
std::string describe_many_modes(const scene::PreparedMachine& prepared);

}  // namespace rubsweep::report
