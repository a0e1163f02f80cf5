#pragma once

#include <cstddef>
#include <string>

namespace rubsweep::apps {

/// Memory of this machine, in bytes.
std::size_t machine_memory_bytes();

/// How many of `cells` are run first to tell how long all of them take: a few for each thread, and no more
/// than a sixteenth, so that nobody waits long for the answer. 0 where there are too few for that.
std::size_t pilot_count(std::size_t cells, std::size_t threads);

/// "about 0:12:30 by 32 cells spread over the map", when those took `elapsed_s` seconds and `left` remain;
/// empty for a small map, of less than 1000 cells, that takes less than ten seconds.
std::string forecast(std::size_t pilots, double elapsed_s, std::size_t left);

}  // namespace rubsweep::apps
