#pragma once

#include <vector>

#include "rubsweep/config/axis.hpp"
#include "rubsweep/config/printer.hpp"
#include "rubsweep/config/value.hpp"
#include "rubsweep/ring/chart.hpp"

namespace rubsweep::config {

/// `chart`: {parameter, load, over}. `load` counts from 0, without it every load; `over` is an axis (see
/// axis.hpp).
ring::ChartAxis read_ring_chart(const Value& value, const std::vector<ring::Load>& loads);
void print_ring_chart(Printer& printer, const ring::ChartAxis& axis, AxisPrint how);

}  // namespace rubsweep::config
