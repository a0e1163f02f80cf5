#pragma once

#include <filesystem>
#include <string_view>

#include "rubsweep_arguments.hpp"

/// report.html is written by rubreport, which stands beside this program and runs as its child.
namespace rubsweep::apps {

/// Throws IoError where there is no rubreport, with what to do.
void require_report_program();

/// Writes report.html of the finished map in `directory` and returns an exit code: 128 + signal when a signal
/// came before it was written; then an older report is as it was. `program`: who says what is to be said.
/// Throws IoError.
int write_report(std::string_view program, const RubsweepArguments& arguments,
                 const std::filesystem::path& directory);

}  // namespace rubsweep::apps
