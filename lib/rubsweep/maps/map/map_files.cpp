#include "rubsweep/maps/map/map_files.hpp"

#include <fmt/format.h>

#include <charconv>

#include "rubsweep/core/numerics/split_mix.hpp"

namespace rubsweep::map {

std::size_t share_of(std::size_t cell, std::size_t count, bool refined) {
  return (refined ? numerics::split_mix(cell) : cell) % count;
}

std::string share_name(const std::optional<Share>& part) {
  return part ? fmt::format("map.shard-{}-of-{}", part->index + 1, part->count) : "map";
}

std::size_t share_count_of(std::string_view name) {
  constexpr std::string_view before = "-of-";
  const std::size_t at = name.find(before);
  std::size_t count = 0;
  if (!name.starts_with("map.shard-") || at == std::string_view::npos) return 0;
  std::from_chars(name.data() + at + before.size(), name.data() + name.size(), count);
  return count;
}

}  // namespace rubsweep::map
