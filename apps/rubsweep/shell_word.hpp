#pragma once

#include <string>

namespace rubsweep::apps {

/// A word of a command line, in quotes where a shell would take it apart.
std::string shell_word(const std::string& text);

}  // namespace rubsweep::apps
