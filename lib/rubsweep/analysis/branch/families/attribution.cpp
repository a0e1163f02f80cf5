#include "rubsweep/analysis/branch/families/attribution.hpp"

#include <algorithm>
#include <array>
#include <numbers>

#include "rubsweep/analysis/branch/continuation/branch_point.hpp"
#include "rubsweep/core/scene/build_scene.hpp"
#include "rubsweep/core/structure/stability.hpp"

namespace rubsweep::branch::families {
namespace {

/// Attribution by the family that the kick of `cell` leads to, on the way to a neighbour.
MapEdge seen_from(std::size_t cell, std::size_t neighbour, const Family& family) {
  MapEdge edge{cell, neighbour, Attribution::unresolved, {}};
  if (const FamilyEnd* end = family.end_between(cell, neighbour)) {
    edge.kind = end->kind;
    if (is_an_end(end->kind)) edge.attribution = Attribution::ceases;
  } else if (family.orbits.contains(neighbour)) {
    edge.attribution = Attribution::basin;
  }
  return edge;
}

/// Attribution by the quiet motion: it exists in a cell or not, whatever lies between.
MapEdge quiet_seen_from(std::size_t cell, std::size_t neighbour, std::span<const Quiet> quiet) {
  MapEdge edge{cell, neighbour, Attribution::unresolved, {}};
  if (quiet[cell] != Quiet::stable) return edge;
  switch (quiet[neighbour]) {
    case Quiet::stable:
      edge.attribution = Attribution::basin;
      break;
    case Quiet::unstable:
      edge.attribution = Attribution::ceases;
      edge.kind = to_string(continuation::EventKind::stability);
      break;
    case Quiet::touches:
      edge.attribution = Attribution::ceases;
      edge.kind = to_string(continuation::EventKind::graze);
      break;
  }
  return edge;
}

/// The stronger of the two: what ceases, then what is there on both sides.
MapEdge together(const MapEdge& there, const MapEdge& back) {
  const bool stronger =
      back.attribution < there.attribution || (back.attribution == there.attribution && there.kind.empty());
  MapEdge edge = stronger ? back : there;
  if (edge.attribution == Attribution::basin && there.attribution != back.attribution) edge.kind = one_motion;
  return edge;
}

}  // namespace

std::vector<Quiet> quiet_cells(const sweep::Study& study) {
  const scene::PreparedMachine prepared = scene::prepare_machine(study.machine);
  std::vector<bool> grows;
  for (const double speed_hz : study.grid.speed_hz)
    grows.push_back(structure::grows(prepared.assembly, 2 * std::numbers::pi * speed_hz));
  std::vector<Quiet> cells;
  for (const double unbalance : study.grid.unbalance) {
    for (std::size_t i = 0; i < grows.size(); ++i) {
      const scene::Cell cell =
          scene::build_cell(prepared, study.grid.speed_hz[i], sweep::unbalance_of(study.grid, unbalance));
      cells.push_back(cell.start != scene::Start::quiet ? Quiet::touches
                      : grows[i]                        ? Quiet::unstable
                                                        : Quiet::stable);
    }
  }
  return cells;
}

bool is_an_end(std::string_view kind) {
  constexpr std::array endings{continuation::Ending::left_range, continuation::Ending::failed,
                               continuation::Ending::step_too_small, continuation::Ending::singular,
                               continuation::Ending::point_limit};
  return std::ranges::none_of(endings,
                              [&](continuation::Ending ending) { return to_string(ending) == kind; });
}

std::vector<MapEdge> attribute(const sweep::Grid& grid, std::span<const std::string> labels,
                               const std::vector<Family>& families, std::span<const Quiet> quiet,
                               std::string_view quiet_label) {
  std::vector<const Family*> family_of(labels.size(), nullptr);
  for (const Family& family : families)
    for (const std::size_t cell : family.reached) family_of[cell] = &family;
  const auto seen = [&](std::size_t cell, std::size_t neighbour) -> MapEdge {
    if (family_of[cell] != nullptr) return seen_from(cell, neighbour, *family_of[cell]);
    if (labels[cell] == quiet_label) return quiet_seen_from(cell, neighbour, quiet);
    return {cell, neighbour, Attribution::unresolved, {}};
  };
  std::vector<MapEdge> edges;
  for (std::size_t cell = 0; cell < labels.size(); ++cell) {
    for (const std::size_t next : neighbours_of(grid, cell)) {
      if (next < cell || labels[cell] == labels[next]) continue;
      MapEdge edge = together(seen(cell, next), seen(next, cell));
      edge.first = cell;
      edge.second = next;
      edges.push_back(edge);
    }
  }
  return edges;
}

}  // namespace rubsweep::branch::families
