#pragma once

#include <filesystem>

#include "compare_maps.hpp"

namespace rubsweep::apps {

/// Writes the compared cells as a table, each with its result and both labels; `rubplot compare` draws a
/// figure from it. The comments at its begin name both files and the tolerance. The figure takes its units
/// from the configuration that lies beside the first file. Throws IoError.
void write_compared_cells(const std::filesystem::path& file, const MapComparison& comparison,
                          const std::filesystem::path& a, const std::filesystem::path& b, double tolerance);

}  // namespace rubsweep::apps
