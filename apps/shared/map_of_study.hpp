#pragma once

#include <filesystem>
#include <string_view>

#include "rubreport/map_table.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::apps {

/// The map at `path`, with its rows in the order of the cells; `program` is the name in messages. Throws
/// ConfigError where the map belongs to another study, IoError where it was changed or is incomplete.
page::MapTable read_map_of(const sweep::Study& study, const std::filesystem::path& path,
                           std::string_view program);

}  // namespace rubsweep::apps
