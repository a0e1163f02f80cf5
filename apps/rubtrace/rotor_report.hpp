#pragma once

#include <filesystem>

#include "rubsweep/analysis/design/unbalance_response.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/sweep/study.hpp"
#include "rubtrace_arguments.hpp"

namespace rubsweep::apps {

/// Speeds of a rotor report.
struct ReportSpeeds {
  design::SpeedRange operating;  ///< as asked for, or the speeds of the sweep, which may be one
  design::SpeedRange shown;      ///< from standstill, or the begin of the tables, to somewhat above
  double deflected_hz = 0;       ///< speed of the deflected shape
};

/// Throws UsageError where the machine may not have a speed that was asked for, ConfigError where the tables
/// of its supports do not reach the speeds of the sweep.
ReportSpeeds report_speeds(const RubtraceArguments& arguments, const sweep::Study& study);

/// Computes the tables of a rotor report, writes them into a directory, and draws its page. Returns the exit
/// code.
int run_rotor_report(const RubtraceArguments& arguments, const config::RunConfig& config,
                     const std::filesystem::path& directory);

}  // namespace rubsweep::apps
