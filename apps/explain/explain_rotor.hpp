#pragma once

#include <string>
#include <vector>

#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/core/model/rotor_kit.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"

namespace rubsweep::apps {

/// Lines for `--explain` on the rotor of a machine: its coordinates, its reduction and its omissions.
/// `by_tables`: supports depend on the speed by tables, and `prepared` is the machine at one of its speeds.
std::string explain_rotor(const scene::PreparedMachine& prepared, bool by_tables);

/// Lines about the matrices of a kit: size, mass, nodes, and which matrices are symmetric.
std::string explain_matrices(const model::RotorKit& kit);

/// Lines for people: coefficients of every support that follows a table, at the slowest, a middle and the
/// fastest of these speeds, all of which must lie within the tables. Empty where there is no table.
std::string explain_tables(const model::Machine& machine, std::vector<double> speeds_hz);

/// One line for every table with too few points to fix the curve between them; empty where there is none.
std::string describe_sparse_tables(const model::Machine& machine);

}  // namespace rubsweep::apps
