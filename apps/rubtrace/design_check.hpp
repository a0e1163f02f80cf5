#pragma once

#include <filesystem>

#include "rubsweep/analysis/design/unbalance_response.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/sweep/study.hpp"
#include "rubtrace_arguments.hpp"

namespace rubsweep::apps {

/// The range that is asked for, else that of the sweep. Throws UsageError where either is none of this
/// machine.
design::SpeedRange operating_range(const DesignCheckArguments& arguments, const sweep::Study& study);

/// Checks the design of the arguments, writes its files into `directory` and prints the page. Returns an exit
/// code.
int run_design_check(const RubtraceArguments& arguments, const config::RunConfig& config,
                     const std::filesystem::path& directory);

}  // namespace rubsweep::apps
