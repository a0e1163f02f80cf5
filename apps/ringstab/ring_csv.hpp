#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rubsweep/ring/analysis.hpp"
#include "rubsweep/ring/assembly.hpp"
#include "rubsweep/ring/study.hpp"

namespace rubsweep::apps {

/// A line beginning with `#` about units and signs.
std::string ring_comments();

/// CSV with speed_rpm, mode, real_per_s, imaginary_rad_per_s: every mode at every speed. A conjugate pair is
/// represented by its root with positive frequency; a mode with two real roots has two rows.
std::string eigenvalues_csv(const ring::Track& track);

/// CSV with kind, speed_rpm, modes (joined by " + "), note.
std::string onsets_csv(const std::vector<ring::Onset>& onsets);

/// CSV with name, closed_form_rpm, numeric_rpm (empty: not found within the range of speeds).
std::string critical_speeds_csv(const std::vector<ring::CriticalSpeed>& speeds);

/// Steady state at every speed of the study.
std::vector<ring::StaticLoad> static_loads(const ring::Study& study);

/// CSV with speed_rpm, load, normal_force_n, slip_m_per_s, valid (yes or no: whether every load presses and
/// slips forward at this speed).
std::string static_load_csv(const ring::Study& study, const std::vector<ring::StaticLoad>& loads);

/// Column names of chart.csv, beginning with the parameter; without a line end.
std::string chart_header(const ring::ChartAxis& axis);

/// Rows for one line of the chart, without the last line end: parameter, speed_rpm, state (stable, flutter,
/// divergence, divergence+flutter), growth_per_s and frequency_rad_per_s of the fastest growing root,
/// unstable_eigenvalues, status. A line that failed has a single row.
std::string chart_rows(const ring::Study& study, const ring::ChartLine& line);

/// Header and rows of the computed lines, in the order of the axis.
std::string chart_csv(const ring::Study& study, const std::vector<std::optional<ring::ChartLine>>& lines);

/// Header, and for every onset a row with parameter, kind, speed_rpm, note.
std::string chart_onsets_csv(const ring::Study& study,
                             const std::vector<std::optional<ring::ChartLine>>& lines);

}  // namespace rubsweep::apps
