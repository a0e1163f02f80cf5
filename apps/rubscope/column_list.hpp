#pragma once

#include <string>

#include "rubsweep/measurement/recording/channels.hpp"

namespace rubsweep::apps {

/// List of what was read from a file: rows, sampling rate, and number, name, unit, range and first values of
/// every column; then the parts that were left out, with the reasons, and the entries that the description of
/// the instrument must have because the file lacks them.
std::string column_list(const recording::Channels& channels, const std::string& name);

}  // namespace rubsweep::apps
