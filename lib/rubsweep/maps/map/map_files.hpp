#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rubsweep::map {

/// The cells that are `index` modulo `count`: a part of every map that takes about as long as the other
/// parts. Of a refined map, whose cells lie on lattices, those that are by their number well mixed.
struct Share {
  std::size_t index = 0;
  std::size_t count = 1;
};

/// Index of the share that has a cell, of a division into `count`.
std::size_t share_of(std::size_t cell, std::size_t count, bool refined);

/// Name of its files without their endings: `map.shard-I-of-N` with I from 1, or `map` of the whole.
std::string share_name(const std::optional<Share>& part);

/// N of the name of a part, with any ending; 0 of any other name.
std::size_t share_count_of(std::string_view name);

/// Files of rubbranch --map about a map.
inline constexpr std::array<std::string_view, 4> family_files{"boundaries.csv", "contradictions.csv",
                                                              "edges.csv", "families.csv"};

/// Files of rubbasin about its map.
inline constexpr std::array<std::string_view, 2> slice_files{"attractors.csv", "slice.csv"};

/// Journal and lock of rubbranch --map, which stay until the files above are there.
inline constexpr std::string_view family_journal_file = "families.journal",
                                  family_lock_file = "families.lock";

inline constexpr std::string_view report_page_file = "report.html";

/// All cells of a refined map with the motion that they show.
inline constexpr std::string_view painted_map_file = "painted.csv";

/// All results that are made of a map and lie beside it: without that map they mean nothing.
inline std::vector<std::string_view> derived_files() {
  std::vector<std::string_view> names{report_page_file, painted_map_file};
  names.insert(names.end(), family_files.begin(), family_files.end());
  names.insert(names.end(), slice_files.begin(), slice_files.end());
  return names;
}

}  // namespace rubsweep::map
