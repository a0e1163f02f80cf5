#pragma once

#include <cstddef>

#include "rubsweep/config/printer.hpp"
#include "rubsweep/config/value.hpp"
#include "rubsweep/integrate/run/options.hpp"

namespace rubsweep::config {

/// `solver`: every key is optional, the defaults are those of integrate::SolverOptions. The exact solver is
/// refused where there are more `stops` than it takes.
integrate::run::SolverOptions read_solver(const Value& value, std::size_t stops);
void print_solver(Printer& printer, const integrate::run::SolverOptions& solver);

}  // namespace rubsweep::config
