#pragma once

#include "rubsweep/core/model/hertz.hpp"
#include "rubsweep/maps/config/yaml/printer.hpp"
#include "rubsweep/maps/config/yaml/value.hpp"

namespace rubsweep::config::machine {

/// `hertz` of a stop: {length_m, rotor: {radius_m, youngs_modulus_pa, poisson_ratio}, casing: {the same,
/// shape: cylinder, flat or hole}, design_force_n, half_width: textbook or paper}; empty after it added a
/// problem.
std::optional<model::HertzLine> read_hertz(const yaml::Value& value);
void print_hertz(yaml::Printer& printer, const model::HertzLine& contact);

}  // namespace rubsweep::config::machine
