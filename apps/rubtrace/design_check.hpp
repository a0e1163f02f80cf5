#pragma once

#include <filesystem>
#include <optional>

#include "rubsweep/analysis/design/design_check.hpp"
#include "rubsweep/analysis/design/unbalance_response.hpp"
#include "rubsweep/core/scene/prepared_machine.hpp"
#include "rubsweep/maps/config/run_config.hpp"
#include "rubsweep/maps/sweep/study.hpp"
#include "rubtrace_arguments.hpp"

namespace rubsweep::apps {

/// The operating range given by the arguments, else the speeds of the sweep. Throws UsageError where either
/// is not allowed for this machine.
design::SpeedRange operating_range(const DesignCheckArguments& arguments, const sweep::Study& study);

/// The machine at the other end of its bearings' clearances, and what is asked of it.
struct OtherEnd {
  config::RunConfig config;
  scene::PreparedMachine prepared;
  design::DesignQuestions questions;
};

/// Reads the machine that --other-end gives; empty without that option. Throws ConfigError, with the place of
/// every problem, where it cannot be checked.
std::optional<OtherEnd> read_other_end(const RubtraceArguments& arguments);

/// Runs the design check, writes its files into `directory` and prints its page. Returns an exit code.
int run_design_check(const RubtraceArguments& arguments, const config::RunConfig& config,
                     const std::filesystem::path& directory);

}  // namespace rubsweep::apps
