#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

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

}  // namespace rubsweep::map
