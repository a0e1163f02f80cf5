#pragma once

#include <filesystem>

#include "rubsweep/maps/config/keys/form.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/config/yaml/printer.hpp"
#include "rubsweep/maps/config/yaml/value.hpp"

namespace rubsweep::config {

/// `output`: {directory}.
std::filesystem::path read_output(const yaml::Value& value);
keys::Form output_form();
void print_output(yaml::Printer& printer, const std::filesystem::path& directory);

/// `output` of a rub configuration: {directory, warn_over_clearances}.
void read_run_output(const yaml::Value& value, RunConfig& config);
keys::Form run_output_form();
void print_run_output(yaml::Printer& printer, const RunConfig& config);

}  // namespace rubsweep::config
