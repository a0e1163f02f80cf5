#include "rubsweep/maps/config/yaml/nearest.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace rubsweep::config::yaml {
namespace {

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

bool adds_a_unit(std::string_view name, std::string_view word) {
  return !word.empty() && name.size() > word.size() && name.starts_with(word) && name[word.size()] == '_';
}

}  // namespace

std::optional<std::string_view> nearest(std::string_view word, std::span<const std::string_view> names) {
  std::optional<std::string_view> best;
  for (const std::string_view name : names) {
    if (adds_a_unit(name, word) && (!best || name.size() < best->size())) best = name;
  }
  if (best) return best;
  std::size_t smallest = 0;
  for (const std::string_view name : names) {
    const std::size_t limit = std::max<std::size_t>(1, name.size() / 3);
    if (word.size() > name.size() + limit) continue;
    const std::size_t distance = edit_distance(word, name);
    if (distance > limit || (best && distance >= smallest)) continue;
    best = name;
    smallest = distance;
  }
  return best;
}

}  // namespace rubsweep::config::yaml
