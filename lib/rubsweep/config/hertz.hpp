#pragma once

#include "rubsweep/config/printer.hpp"
#include "rubsweep/config/value.hpp"
#include "rubsweep/model/hertz.hpp"

namespace rubsweep::config {

/// `hertz` of a stop: {length_m, rotor: {radius_m, youngs_modulus_pa, poisson_ratio}, casing: {the same,
/// shape: cylinder, flat or hole}, design_force_n, half_width: textbook or paper, iterations}; empty after it
/// added a problem.
std::optional<model::HertzLine> read_hertz(const Value& value);
void print_hertz(Printer& printer, const model::HertzLine& contact);

}  // namespace rubsweep::config
