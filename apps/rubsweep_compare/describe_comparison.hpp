#pragma once

#include <string>

#include "compare_maps.hpp"

namespace rubsweep::apps {

/// A comparison by `tolerance` for people, ending with "equal" or "different".
std::string describe_comparison(const MapComparison& comparison, double tolerance);

}  // namespace rubsweep::apps
