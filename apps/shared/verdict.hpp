#pragma once

#include <filesystem>
#include <string_view>

#include "rubsweep/maps/map/verified_directory.hpp"

namespace rubsweep::apps {

/// Says the verdict as `program` and returns its exit code; faults alone with `quiet`.
int report_verdict(std::string_view program, const std::filesystem::path& directory,
                   const map::DirectoryVerdict& verdict, bool quiet);

}  // namespace rubsweep::apps
