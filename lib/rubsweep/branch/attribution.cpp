#include "rubsweep/branch/attribution.hpp"

#include <algorithm>
#include <array>

#include "rubsweep/branch/branch_point.hpp"

namespace rubsweep::branch {
namespace {

/// What the family that the kick of `cell` leads to says about the way to a neighbour.
MapEdge seen_from(std::size_t cell, std::size_t neighbour, const Family* family) {
  MapEdge edge{cell, neighbour, Attribution::unresolved, {}};
  if (family == nullptr) return edge;
  if (const FamilyEnd* end = family->end_between(cell, neighbour)) {
    edge.kind = end->kind;
    if (is_an_end(end->kind)) edge.attribution = Attribution::ceases;
  } else if (family->orbits.contains(neighbour)) {
    edge.attribution = Attribution::basin;
  }
  return edge;
}

}  // namespace

bool is_an_end(std::string_view kind) {
  constexpr std::array endings{Ending::left_range, Ending::failed, Ending::step_too_small, Ending::singular,
                               Ending::point_limit};
  return std::ranges::none_of(endings, [&](Ending ending) { return to_string(ending) == kind; });
}

std::vector<MapEdge> attribute(const sweep::Grid& grid, std::span<const std::string> labels,
                               const std::vector<Family>& families) {
  std::vector<const Family*> family_of(labels.size(), nullptr);
  for (const Family& family : families)
    for (const std::size_t cell : family.reached) family_of[cell] = &family;
  std::vector<MapEdge> edges;
  for (std::size_t cell = 0; cell < labels.size(); ++cell) {
    for (const std::size_t next : neighbours_of(grid, cell)) {
      if (next < cell || labels[cell] == labels[next]) continue;
      MapEdge there = seen_from(cell, next, family_of[cell]), back = seen_from(next, cell, family_of[next]);
      // The stronger of the two: what ceases, then what is there on both sides.
      const bool stronger = back.attribution < there.attribution ||
                            (back.attribution == there.attribution && there.kind.empty());
      MapEdge edge = stronger ? back : there;
      edge.first = cell;
      edge.second = next;
      edges.push_back(edge);
    }
  }
  return edges;
}

}  // namespace rubsweep::branch
