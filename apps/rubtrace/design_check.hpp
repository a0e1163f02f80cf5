#pragma once

#include <filesystem>

#include "rubsweep/analysis/design/unbalance_response.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/sweep/study.hpp"
#include "rubtrace_arguments.hpp"

namespace rubsweep::apps {

/// The operating range given by the arguments, else the speeds of the sweep. Throws UsageError where either
/// is not allowed for this machine.
design::SpeedRange operating_range(const DesignCheckArguments& arguments, const sweep::Study& study);

/// Runs the design check, writes its files into `directory` and prints its page. Returns an exit code.
int run_design_check(const RubtraceArguments& arguments, const config::RunConfig& config,
                     const std::filesystem::path& directory);

}  // namespace rubsweep::apps
