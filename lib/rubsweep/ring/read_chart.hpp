#pragma once

#include <vector>

#include "rubsweep/maps/config/study/axis.hpp"
#include "rubsweep/maps/config/yaml/printer.hpp"
#include "rubsweep/maps/config/yaml/value.hpp"
#include "rubsweep/ring/chart.hpp"

namespace rubsweep::config::ring {

/// `chart`: {parameter, load, over}. `load` counts from 0, without it every load; `over` is an axis (see
/// axis.hpp).
rubsweep::ring::ChartAxis read_ring_chart(const yaml::Value& value,
                                          const std::vector<rubsweep::ring::Load>& loads);
void print_ring_chart(yaml::Printer& printer, const rubsweep::ring::ChartAxis& axis, study::AxisPrint how);

}  // namespace rubsweep::config::ring
