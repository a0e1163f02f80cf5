#pragma once

#include <string_view>

#include "rubsweep/maps/sweep/grid.hpp"

namespace rubsweep::report {

/// Throws ConfigError where more axes of a map have several values than `in` has room for, "a report" or "a
/// picture": two, where one of them is over a key.
void require_plane(const sweep::Grid& grid, std::string_view in);

}  // namespace rubsweep::report
