#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rubsweep/ring/analysis.hpp"
#include "rubsweep/ring/assembly.hpp"
#include "rubsweep/ring/study.hpp"

namespace rubsweep::apps {

/// A `#` line on units and signs, with its end.
std::string ring_comments();

/// speed_rpm, mode, real_per_s, imaginary_rad_per_s: at every asked speed every mode; of a conjugate pair the
/// root with the positive frequency, of a mode with two real roots both.
std::string eigenvalues_csv(const ring::Track& track);

/// kind, speed_rpm, modes (joined by " + "), note.
std::string onsets_csv(const std::vector<ring::Onset>& onsets);

/// name, closed_form_rpm, numeric_rpm (empty: not found within the range of speeds).
std::string critical_speeds_csv(const std::vector<ring::CriticalSpeed>& speeds);

/// Steady state at every speed of the study.
std::vector<ring::StaticLoad> static_loads(const ring::Study& study);

/// speed_rpm, load, normal_force_n, slip_m_per_s, valid (yes or no: at this speed every load presses and
/// slips forward).
std::string static_load_csv(const ring::Study& study, const std::vector<ring::StaticLoad>& loads);

/// Column names of chart.csv, the first one being the parameter; without an end of line.
std::string chart_header(const ring::ChartAxis& axis);

/// The rows of one line of the chart, without the last end of line: parameter, speed_rpm, state (stable,
/// flutter, divergence, divergence+flutter), growth_per_s and frequency_rad_per_s of the root that grows
/// fastest, unstable_eigenvalues, status. A line that failed is one row.
std::string chart_rows(const ring::Study& study, const ring::ChartLine& line);

/// The lines that exist, in the order of the axis, with the header.
std::string chart_csv(const ring::Study& study, const std::vector<std::optional<ring::ChartLine>>& lines);

/// Parameter, kind, speed_rpm, note of every onset, with the header.
std::string chart_onsets_csv(const ring::Study& study,
                             const std::vector<std::optional<ring::ChartLine>>& lines);

}  // namespace rubsweep::apps
