#pragma once

#include "shared/command_line.hpp"

/// Options that rubsweep and rubsweep-mpi have in common.
namespace rubsweep::apps {

/// Adds --output, --figure and --fade.
void add_map_files(po::options_description& options);
void add_fresh(po::options_description& options);
void add_report(po::options_description& options);

}  // namespace rubsweep::apps
