#pragma once

#include <optional>

#include "rubsweep/config/yaml/printer.hpp"
#include "rubsweep/config/yaml/value.hpp"
#include "rubsweep/model/casing.hpp"

namespace rubsweep::config::machine {

/// `casing` of a stop: {mass_kg, stiffness_n_per_m, damping_ratio}, all required, or the word `rigid`
/// (empty).
std::optional<model::Casing> read_casing(const yaml::Value& value);
void print_casing(yaml::Printer& printer, const std::optional<model::Casing>& casing);

}  // namespace rubsweep::config::machine
