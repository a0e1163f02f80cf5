#pragma once

#include <cstddef>
#include <string>

#include "rubsweep/maps/sweep/footprint.hpp"

namespace rubsweep::report {

/// "1320 cells on 2 threads: up to 21 MB of memory, 1.4 MB of disk", or "1320 cells on 8 ranks of 2 threads:
/// up to 51 MB of memory each, 1.4 MB of disk".
std::string describe_footprint(const sweep::Study& study, const sweep::Workers& workers);
std::string describe_footprint(const sweep::Study& study, const scene::PreparedMachine& prepared,
                               const sweep::Workers& workers);

/// Throws ConfigError where a process needs more than `bytes` of memory: refused before anything begins, not
/// killed in the middle.
void refuse_more_memory_than(std::size_t bytes, const sweep::Study& study, const sweep::Workers& workers);

}  // namespace rubsweep::report
