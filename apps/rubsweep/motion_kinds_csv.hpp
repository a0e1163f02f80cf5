#pragma once

#include <string>

namespace rubsweep::apps {

/// Table of response::motion::motion_kinds for drawing programs: name, label, colour and colour on a dark
/// background (both `#RRGGBB`), character on a terminal, whether it is hatched, and whether it is a settled
/// rub (1 or 0).
std::string motion_kinds_csv();

}  // namespace rubsweep::apps
