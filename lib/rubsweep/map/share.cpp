#include "rubsweep/map/share.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>

namespace rubsweep::map {
namespace {

/// Steele, Lea & Flood's SplitMix64: all bits of the result depend on all of the number.
std::uint64_t mixed(std::uint64_t number) {
  number += 0x9e3779b97f4a7c15U;
  number = (number ^ (number >> 30U)) * 0xbf58476d1ce4e5b9U;
  number = (number ^ (number >> 27U)) * 0x94d049bb133111ebU;
  return number ^ (number >> 31U);
}

}  // namespace

std::size_t share_of(std::size_t cell, std::size_t count, bool refined) {
  return (refined ? mixed(cell) : cell) % count;
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
