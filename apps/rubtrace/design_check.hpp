#pragma once

#include <filesystem>

#include "rubsweep/config/run_config.hpp"
#include "rubtrace_arguments.hpp"

namespace rubsweep::apps {

/// Checks the design of the arguments, writes its files into `directory` and prints the page. Returns an exit
/// code.
int run_design_check(const RubtraceArguments& arguments, const config::RunConfig& config,
                     const std::filesystem::path& directory);

}  // namespace rubsweep::apps
