#pragma once

#include <string>

#include "compare_maps.hpp"

namespace rubsweep::apps {

/// A gnuplot script with its data in it that draws where two maps differ. `terminal` is gnuplot's (pngcairo,
/// svg), `output` the picture; empty: standard output. Neither heading nor output can be anything but text
/// and a file, whatever they hold; control characters of the heading are shown as '?'. Throws IoError when
/// `output` has such characters: gnuplot has no way to write them.
std::string comparison_figure(const MapComparison& comparison, const std::string& heading,
                              const std::string& terminal, const std::string& output);

}  // namespace rubsweep::apps
