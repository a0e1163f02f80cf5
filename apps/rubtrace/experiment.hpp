#pragma once

#include "rubsweep/maps/config/run_config.hpp"
#include "rubtrace_arguments.hpp"

namespace rubsweep::apps {

/// Runs the experiment of the arguments, writes its files into `directory` and prints the result. Returns an
/// exit code.
int run_experiment(const RubtraceArguments& arguments, const config::RunConfig& config,
                   const std::filesystem::path& directory);

}  // namespace rubsweep::apps
