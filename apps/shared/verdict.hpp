#pragma once

#include <filesystem>
#include <string_view>

#include "shared/verified_directory.hpp"

namespace rubsweep::apps {

/// Prints the verdict under the name `program` and returns its exit code; with `quiet`, prints only faults.
int report_verdict(std::string_view program, const std::filesystem::path& directory,
                   const DirectoryVerdict& verdict, bool quiet);

}  // namespace rubsweep::apps
