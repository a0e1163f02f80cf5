#pragma once

#include <cstddef>
#include <string>

namespace rubsweep::apps {

/// Memory of this machine, in bytes.
std::size_t machine_memory_bytes();

/// From how many missing cells on a forecast is made, and by how many for each thread.
inline constexpr std::size_t least_cells_to_forecast = 1000, pilots_per_thread = 16;

/// "about 0:12:30 by 32 cells spread over the map", when those took `elapsed_s` seconds and `left` remain.
std::string forecast(std::size_t pilots, double elapsed_s, std::size_t left);

}  // namespace rubsweep::apps
