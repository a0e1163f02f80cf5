#pragma once

#include <string>
#include <vector>

#include "rubsweep/core/model/length_text.hpp"
#include "shared/command_line.hpp"

namespace rubsweep::apps {

/// Adds --length-unit and --peak-to-peak for texts and figures, with the names that rubplot uses.
void add_shown_lengths(po::options_description& options);

/// Reads these options. Throws UsageError for an unknown unit.
model::ShownLengths shown_lengths_of(const po::variables_map& given);

/// The corresponding options of rubplot, limited to those that the picture has.
std::vector<std::string> drawn_lengths(const model::ShownLengths& shown, bool has_length_unit,
                                       bool has_peak_to_peak);

}  // namespace rubsweep::apps
