#include "rubsweep/analysis/branch/families/outline.hpp"

#include <map>
#include <optional>
#include <set>
#include <utility>

namespace rubsweep::branch::families {
namespace {

/// Corner of cells, counted in halves of cells: corner (i, j) is below and left of cell (i, j).
using Corner = std::pair<long, long>;

/// One side of a cell inside, on the edge of the domain; null `end`: the map ends there.
struct Edge {
  Corner from, to;
  const FamilyEnd* end = nullptr;
};

class Tracer {
 public:
  Tracer(const sweep::Grid& grid, const Family& family)
      : speeds_(static_cast<long>(grid.speed_hz.size())),
        unbalances_(static_cast<long>(grid.unbalance.size())),
        family_(family) {
    for (const auto& [cell, orbit] : family.orbits) add_sides_of(static_cast<long>(cell));
  }

  std::vector<OutlineLine> trace() {
    // Open lines first, from where the map ends; what is left then are closed ones.
    for (const bool open : {true, false}) {
      for (std::size_t i = 0; i < sides_.size(); ++i) {
        if (used_.contains(i) || sides_[i].end == nullptr) continue;
        if (!open || comes_from_the_edge_of_the_map(i)) follow(i);
      }
    }
    return std::move(lines_);
  }

 private:
  /// Counter-clockwise around the cell.
  void add_sides_of(long cell) {
    const long i = cell % speeds_, j = cell / speeds_;
    add(cell, i, j - 1, {i, j}, {i + 1, j});
    add(cell, i + 1, j, {i + 1, j}, {i + 1, j + 1});
    add(cell, i, j + 1, {i + 1, j + 1}, {i, j + 1});
    add(cell, i - 1, j, {i, j + 1}, {i, j});
  }

  void add(long cell, long i, long j, Corner from, Corner to) {
    Edge edge{from, to, nullptr};
    if (i >= 0 && i < speeds_ && j >= 0 && j < unbalances_) {
      const auto outside = static_cast<std::size_t>(j * speeds_ + i);
      if (family_.orbits.contains(outside)) return;
      edge.end = family_.end_between(static_cast<std::size_t>(cell), outside);
    }
    starts_.emplace(from, sides_.size());
    ends_.emplace(to, sides_.size());
    sides_.push_back(edge);
  }

  bool comes_from_the_edge_of_the_map(std::size_t side) const {
    const auto [first, last] = ends_.equal_range(sides_[side].from);
    for (auto before = first; before != last; ++before) {
      if (sides_[before->second].end == nullptr) return true;
    }
    return false;
  }

  /// The side that goes on where `side` ends: where two cells of the domain meet in a corner only, the one
  /// that turns left, which stays at the same cell.
  std::optional<std::size_t> next_of(std::size_t side) const {
    const auto [first, last] = starts_.equal_range(sides_[side].to);
    std::optional<std::size_t> next;
    for (auto candidate = first; candidate != last; ++candidate) {
      if (!next || turns_left(sides_[side], sides_[candidate->second])) next = candidate->second;
    }
    return next;
  }

  static bool turns_left(const Edge& a, const Edge& b) {
    const long ax = a.to.first - a.from.first, ay = a.to.second - a.from.second;
    const long bx = b.to.first - b.from.first, by = b.to.second - b.from.second;
    return ax * by - ay * bx > 0;
  }

  void follow(std::size_t first) {
    std::optional<std::size_t> side = first;
    OutlineLine line;
    while (side && !used_.contains(*side) && sides_[*side].end != nullptr) {
      used_.insert(*side);
      add_point(*sides_[*side].end, line);
      side = next_of(*side);
    }
    if (side == first) add_point(*sides_[first].end, line);
    lines_.push_back(std::move(line));
  }

  void add_point(const FamilyEnd& end, OutlineLine& line) {
    if (!line.points.empty() && line.kind != end.kind) {
      OutlineLine next{end.kind, {line.points.back()}};
      lines_.push_back(std::exchange(line, std::move(next)));
    }
    line.kind = end.kind;
    line.points.push_back({end.speed_hz, end.unbalance});
  }

  long speeds_, unbalances_;
  const Family& family_;
  std::vector<Edge> sides_;
  std::multimap<Corner, std::size_t> starts_, ends_;
  std::set<std::size_t> used_;
  std::vector<OutlineLine> lines_;
};

}  // namespace

std::vector<OutlineLine> outline_of(const sweep::Grid& grid, const Family& family) {
  return Tracer(grid, family).trace();
}

}  // namespace rubsweep::branch::families
