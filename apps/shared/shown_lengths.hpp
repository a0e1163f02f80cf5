#pragma once

#include <string>
#include <vector>

#include "rubsweep/core/model/length_text.hpp"
#include "shared/command_line.hpp"

namespace rubsweep::apps {

/// --length-unit and --peak-to-peak, named as rubplot names them, for what a person reads: texts and figures.
void add_shown_lengths(po::options_description& options);

/// Throws UsageError for another unit.
model::ShownLengths shown_lengths_of(const po::variables_map& given);

/// The options of rubplot that ask a picture for the same; those of them that the picture has.
std::vector<std::string> drawn_lengths(const model::ShownLengths& shown, bool has_length_unit,
                                       bool has_peak_to_peak);

}  // namespace rubsweep::apps
