#pragma once

#include <string>

#include "rubsweep/maps/report/compare_maps.hpp"

namespace rubsweep::report {

/// A comparison by `tolerance` for people, ending with "equal" or "different".
std::string describe_comparison(const MapComparison& comparison, double tolerance);

}  // namespace rubsweep::report
