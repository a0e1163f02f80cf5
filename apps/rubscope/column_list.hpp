#pragma once

#include <string>

#include "rubsweep/measurement/recording/channels.hpp"

namespace rubsweep::apps {

/// Listing of what was understood of a file: rows, sampling rate, and of every column its number, name,
/// unit, range and first values; then what was left out and why, what was passed over, and what a description
/// of the instrument has to say where the file does not.
std::string column_list(const recording::Channels& channels, const std::string& name);

}  // namespace rubsweep::apps
