#pragma once

#include <filesystem>

#include "compare_maps.hpp"

namespace rubsweep::apps {

/// Writes the cells of two maps as a table, each with its verdict and both labels, which `rubplot compare`
/// draws. Its head names both files and the tolerance: the units of the picture are those of the
/// configuration beside the first. Throws IoError.
void write_compared_cells(const std::filesystem::path& file, const MapComparison& comparison,
                          const std::filesystem::path& a, const std::filesystem::path& b, double tolerance);

}  // namespace rubsweep::apps
