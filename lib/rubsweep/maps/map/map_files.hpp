#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rubsweep::map {

/// A part of a map: the cells whose number is `index` modulo `count`, so that all parts take about the same
/// time. In a refined map, whose cells lie on a lattice, a hash first mixes the cell numbers.
struct Share {
  std::size_t index = 0;
  std::size_t count = 1;
};

/// Index of the share to which a cell belongs, in a division into `count` shares.
std::size_t share_of(std::size_t cell, std::size_t count, bool refined);

/// Common name of the files of a share: `map.shard-I-of-N` with I from 1, or `map` for the whole map.
std::string share_name(const std::optional<Share>& part);

/// N in the file name of a part, whatever its ending; 0 for any other name.
std::size_t share_count_of(std::string_view name);

/// Files that rubbranch --map writes beside a map.
inline constexpr std::array<std::string_view, 4> family_files{"boundaries.csv", "contradictions.csv",
                                                              "edges.csv", "families.csv"};

/// Files that rubbasin writes beside its map.
inline constexpr std::array<std::string_view, 2> slice_files{"attractors.csv", "slice.csv"};

/// Journal and lock of rubbranch --map, which exist until the files above are written.
inline constexpr std::string_view family_journal_file = "families.journal",
                                  family_lock_file = "families.lock";

inline constexpr std::string_view report_page_file = "report.html";

/// Table of all cells of a refined map, with the motion that each shows.
inline constexpr std::string_view painted_map_file = "painted.csv";

/// All results that are computed from a map and stored beside it. Without the map they are useless.
inline std::vector<std::string_view> derived_files() {
  std::vector<std::string_view> names{report_page_file, painted_map_file};
  names.insert(names.end(), family_files.begin(), family_files.end());
  names.insert(names.end(), slice_files.begin(), slice_files.end());
  return names;
}

}  // namespace rubsweep::map
