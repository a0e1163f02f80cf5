#pragma once

#include <string>

#include "compare_maps.hpp"

namespace rubsweep::apps {

/// A gnuplot script, with its data inside, that shows where two maps differ. `terminal`: gnuplot's terminal
/// (pngcairo, svg); `output`: the picture's file, empty for standard output. Heading and output are quoted
/// safely, so they cannot act as commands; control characters in the heading become '?'. Throws IoError where
/// `output` has control characters, which gnuplot cannot write.
std::string comparison_figure(const MapComparison& comparison, const std::string& heading,
                              const std::string& terminal, const std::string& output);

}  // namespace rubsweep::apps
