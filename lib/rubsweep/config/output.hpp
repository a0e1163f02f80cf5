#pragma once

#include <filesystem>

#include "rubsweep/config/printer.hpp"
#include "rubsweep/config/value.hpp"

namespace rubsweep::config {

/// `output`: {directory}.
std::filesystem::path read_output(const Value& value);
void print_output(Printer& printer, const std::filesystem::path& directory);

}  // namespace rubsweep::config
