#pragma once

#include "rubsweep/config/printer.hpp"
#include "rubsweep/config/value.hpp"
#include "rubsweep/response/options.hpp"

namespace rubsweep::config {

/// `response`: every key is optional, the defaults are those of response::ResponseOptions. Two windows must
/// fit into the longest run, two turns of the largest order into a window, four samples into its shortest
/// period.
response::ResponseOptions read_response(const Value& value);
void print_response(Printer& printer, const response::ResponseOptions& response);

}  // namespace rubsweep::config
