#pragma once

#include <string>
#include <string_view>

namespace rubsweep::apps {

/// Answer to --version, one line each: the program's name and version, the commit of its sources, the
/// compiler.
std::string version_text(std::string_view program);

}  // namespace rubsweep::apps
