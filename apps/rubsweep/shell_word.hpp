#pragma once

#include <string>

namespace rubsweep::apps {

/// A word of a command line, quoted if a shell would otherwise split or change it.
std::string shell_word(const std::string& text);

}  // namespace rubsweep::apps
