#pragma once

#include <string>
#include <vector>

#include "rubsweep/core/model/machine.hpp"

namespace rubsweep::report {

/// For people: the coefficients of every support that follows a table, at the slowest, a middle and the
/// fastest of these speeds, which the tables must reach. Empty where there is no table.
std::string explain_tables(const model::Machine& machine, std::vector<double> speeds_hz);

/// One line for every table with so few points that the curve between them is left to chance; empty where
/// there is none.
std::string describe_sparse_tables(const model::Machine& machine);

}  // namespace rubsweep::report
