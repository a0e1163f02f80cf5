#pragma once

#include <filesystem>
#include <string_view>

#include "rubsweep_arguments.hpp"

/// Runs rubreport, which lies beside this program, as a child process that writes report.html.
namespace rubsweep::apps {

/// Throws IoError, with advice, where rubreport is missing.
void require_report_program();

/// Writes report.html of the finished map in `directory` and returns an exit code. If a signal came before
/// the report was written, the code is 128 + signal and an older report stays unchanged. `program`: name in
/// messages. Throws IoError.
int write_report(std::string_view program, const RubsweepArguments& arguments,
                 const std::filesystem::path& directory);

}  // namespace rubsweep::apps
