#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rubsweep/ring/analysis.hpp"
#include "rubsweep/ring/assembly.hpp"
#include "rubsweep/ring/study.hpp"

namespace rubsweep::apps {

/// Summary for a terminal: ranges of stability, kinds of instability, onsets, and closed-form critical
/// speeds.
std::string ring_summary(const ring::Study& study, const ring::Analysis& analysis);

/// Speeds at which the model's assumption fails that contact and slip never end, according to the static
/// state.
std::string validity_summary(const ring::Study& study, const std::vector<ring::StaticLoad>& loads);

/// Lines of the chart that failed, and the shares of its points; empty without a chart.
std::string chart_summary(const std::vector<std::optional<ring::ChartLine>>& lines);

/// Explanation of the model, of its omissions and their reasons, and of the method of solution.
std::string explain_ring(const ring::Study& study);

}  // namespace rubsweep::apps
