#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rubsweep/ring/study.hpp"

namespace rubsweep::ring {

/// Column names of chart.csv, the first one being the parameter; without an end of line.
std::string chart_header(const ChartAxis& axis);

/// The rows of one line of the chart, without the last end of line: parameter, speed_rpm, state (stable,
/// flutter, divergence, divergence+flutter), growth_per_s and frequency_rad_per_s of the root that grows
/// fastest, unstable_eigenvalues, status. A line that failed is one row.
std::string chart_rows(const Study& study, const ChartLine& line);

/// The lines that exist, in the order of the axis, with the header.
std::string chart_csv(const Study& study, const std::vector<std::optional<ChartLine>>& lines);

/// Parameter, kind, speed_rpm, note of every onset, with the header.
std::string chart_onsets_csv(const Study& study, const std::vector<std::optional<ChartLine>>& lines);

}  // namespace rubsweep::ring
