#pragma once

#include "rubsweep/maps/config/keys/form.hpp"
#include "rubsweep/maps/config/yaml/printer.hpp"
#include "rubsweep/maps/config/yaml/value.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::config::study {

/// `response` and `solver`: every key is optional, the defaults are those of the structs. Two windows must
/// fit into the longest run, two turns of the largest order into a window, four samples into its shortest
/// period.
void read_response(const yaml::Value& value, sweep::Study& study);
keys::Form response_form();
void print_response(yaml::Printer& printer, const sweep::Study& study);

/// `solver`: the exact one is refused where there are more `stops` than it takes.
integrate::run::SolverOptions read_solver(const yaml::Value& value, std::size_t stops);
keys::Form solver_form();
void print_solver(yaml::Printer& printer, const integrate::run::SolverOptions& solver);

}  // namespace rubsweep::config::study
