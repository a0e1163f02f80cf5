#pragma once

#include <string>

#include "compare_maps.hpp"

namespace rubsweep::apps {

/// Text about a comparison with this tolerance; ends with "equal" or "different".
std::string describe_comparison(const MapComparison& comparison, double tolerance);

}  // namespace rubsweep::apps
