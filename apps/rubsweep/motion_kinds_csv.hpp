#pragma once

#include <string>

namespace rubsweep::apps {

/// Table of response::motion::motion_kinds, for programs that draw: name, label, colour and the colour on a
/// dark background (both `#RRGGBB`), sign on a terminal, whether it is hatched and whether it is a rub that
/// has settled (1 or 0).
std::string motion_kinds_csv();

}  // namespace rubsweep::apps
