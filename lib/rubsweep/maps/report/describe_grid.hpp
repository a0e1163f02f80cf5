#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "rubsweep/maps/sweep/footprint.hpp"
#include "rubsweep/maps/sweep/grid.hpp"

namespace rubsweep::report {

/// Throws ConfigError where an axis is over a key and more than two axes of the map have several values,
/// since the kind of output `in` ("a report" or "a picture") can show only two.
void require_plane(const sweep::Grid& grid, std::string_view in);

/// Phrase for the size of the smallest island that a refined map surely finds (sweep::island_bound).
std::string describe_island_bound(const sweep::Grid& grid);

/// Lines for a terminal on a complete refined map: its cost and the size of islands that it may miss.
/// `labels` as in sweep::wanted_cells.
std::string describe_refinement(const sweep::Grid& grid, std::span<const int> labels);

/// Memory and disk space in words: "1320 cells on 2 threads: up to 21 MB of memory, 1.4 MB of disk". With
/// MPI: "1320 cells on 8 ranks of 2 threads: up to 51 MB of memory each, 1.4 MB of disk".
std::string describe_footprint(const sweep::Study& study, const sweep::Workers& workers);
std::string describe_footprint(const sweep::Study& study, const scene::PreparedMachine& prepared,
                               const sweep::Workers& workers);

/// Throws ConfigError where a process would need more than `bytes` of memory, so that the sweep is refused
/// before it begins and not killed in the middle.
void refuse_more_memory_than(std::size_t bytes, const sweep::Study& study, const sweep::Workers& workers);

}  // namespace rubsweep::report
