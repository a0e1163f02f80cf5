#pragma once

#include <string>

#include "shared/command_line.hpp"

namespace rubsweep::apps {

/// Options of rubtrace that --help shows.
po::options_description rubtrace_options();

/// Text of --help: usage, options, examples, written files and exit codes.
std::string rubtrace_help();

}  // namespace rubsweep::apps
