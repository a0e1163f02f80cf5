#pragma once

#include <functional>
#include <string_view>

#include "rubsweep/maps/config/run_config.hpp"
#include "shared/action.hpp"

namespace rubsweep::apps {

/// Answers to --check, --explain and --print-config for the cells of a study, with warnings and questions.
/// `run`: action of the program without these options. Program, arguments and configuration must outlive it.
StudyActions study_actions(std::string_view program, const StudyArguments& arguments,
                           const config::RunConfig& config, std::function<int()> run);

}  // namespace rubsweep::apps
