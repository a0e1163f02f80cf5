#pragma once

#include <cstddef>

#include "rubsweep/core/integrate/run/options.hpp"
#include "rubsweep/maps/config/keys/form.hpp"
#include "rubsweep/maps/config/yaml/printer.hpp"
#include "rubsweep/maps/config/yaml/value.hpp"

namespace rubsweep::config::study {

/// `solver`: every key is optional, the defaults are those of integrate::SolverOptions. The exact solver is
/// refused where there are more `stops` than it takes.
integrate::run::SolverOptions read_solver(const yaml::Value& value, std::size_t stops);
keys::Form solver_form();
void print_solver(yaml::Printer& printer, const integrate::run::SolverOptions& solver);

}  // namespace rubsweep::config::study
