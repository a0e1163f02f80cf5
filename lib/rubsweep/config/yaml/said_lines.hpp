#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace rubsweep::config::yaml {

/// Remembers lines of a message as it was shown; those behind the first 1000 are forgotten. For any thread.
void remember_lines(std::string_view shown);

/// Lines of all messages that this process showed on stderr, without empty ones.
std::vector<std::string> said_lines();

}  // namespace rubsweep::config::yaml
