#pragma once

#include <functional>

#include "rubsweep/maps/config/run_config.hpp"
#include "rubtrace_arguments.hpp"
#include "shared/action.hpp"

namespace rubsweep::apps {

/// Answers to --check, --explain and --print-config for the experiment or design check of the arguments;
/// `run` runs it. Arguments and configuration must outlive it. Throws UsageError and ConfigError where the
/// machine does not allow the given speeds.
StudyActions experiment_actions(const RubtraceArguments& arguments, const config::RunConfig& config,
                                std::function<int()> run);

}  // namespace rubsweep::apps
