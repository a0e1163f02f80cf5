#pragma once

#include <filesystem>
#include <string_view>

#include "rubsweep/analysis/page/map_table.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::apps {

/// The map at `path`, for `program`, its rows in the order of the cells. Throws ConfigError where it is not
/// one of `study`, and IoError, also where it is not as it was written or not the whole map.
page::MapTable read_map_of(const sweep::Study& study, const std::filesystem::path& path,
                           std::string_view program);

}  // namespace rubsweep::apps
