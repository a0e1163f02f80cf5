#include "rubsweep/maps/sweep/refinement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "rubsweep/maps/sweep/grid.hpp"

namespace rubsweep::sweep {
namespace {

/// One axis of a plane: its number of cells, and the difference of cell numbers between neighbours.
struct PlaneAxis {
  std::size_t count = 1, stride = 0;
};

/// Planes in which blocks are formed: the first two axes with several values, one plane for each combination
/// of the others.
struct Planes {
  std::array<PlaneAxis, 2> sides;
  std::vector<std::size_t> origins;
};

Planes planes_of(const Grid& grid) {
  std::vector<std::size_t> counts{grid.speed_hz.size(), grid.unbalance.size()};
  for (const KeyAxis& axis : grid.axes) counts.push_back(axis.values.size());
  Planes planes{{}, {0}};
  std::size_t stride = 1, found = 0;
  for (const std::size_t count : counts) {
    if (count > 1 && found < 2) {
      planes.sides[found++] = {count, stride};
    } else if (count > 1) {
      std::vector<std::size_t> origins;
      for (std::size_t i = 0; i < count; ++i) {
        for (const std::size_t origin : planes.origins) origins.push_back(origin + i * stride);
      }
      planes.origins = std::move(origins);
    }
    stride *= count;
  }
  return planes;
}

/// Interval of indices on an axis, both ends included. If the axis has one value, the ends are equal.
struct Interval {
  std::size_t first = 0, last = 0;

  std::size_t middle() const { return first + (last - first) / 2; }
  bool splits() const { return last - first > 1; }
};

/// Both halves of an interval that can be split, else the interval itself.
std::vector<Interval> halves(const Interval& whole) {
  if (!whole.splits()) return {whole};
  return {{whole.first, whole.middle()}, {whole.middle(), whole.last}};
}

std::vector<Interval> lattice(std::size_t count, int levels) {
  if (count == 1) return {{0, 0}};
  const std::size_t step = std::size_t{1} << levels;
  std::vector<Interval> intervals;
  for (std::size_t first = 0; first + 1 < count; first += step)
    intervals.push_back({first, std::min(first + step, count - 1)});
  return intervals;
}

struct Block {
  std::size_t origin = 0;
  std::array<Interval, 2> intervals;

  bool splits() const { return intervals[0].splits() || intervals[1].splits(); }
};

std::size_t cell_at(const Planes& planes, std::size_t origin, std::size_t i, std::size_t j) {
  return origin + i * planes.sides[0].stride + j * planes.sides[1].stride;
}

/// Calls `visit` with every block of the lattice.
template <class Visit>
void visit_lattice(const Planes& planes, int levels, const Visit& visit) {
  const auto across = lattice(planes.sides[0].count, levels), up = lattice(planes.sides[1].count, levels);
  for (const std::size_t origin : planes.origins) {
    for (const Interval& j : up) {
      for (const Interval& i : across) visit(Block{origin, {i, j}});
    }
  }
}

std::vector<std::size_t> corners(const Planes& planes, const Block& block) {
  std::vector<std::size_t> cells;
  for (const std::size_t j : {block.intervals[1].first, block.intervals[1].last}) {
    for (const std::size_t i : {block.intervals[0].first, block.intervals[0].last})
      cells.push_back(cell_at(planes, block.origin, i, j));
  }
  return cells;
}

/// Probe cells of a block, spread by the additive recurrence with the plastic number, which leaves only small
/// gaps for any number of probes.
std::vector<std::size_t> probes(const Planes& planes, const Block& block, int count) {
  constexpr std::array steps{0.7548776662466927, 0.5698402909980532};
  std::vector<std::size_t> cells;
  for (int k = 0; k < count; ++k) {
    std::array<std::size_t, 2> place;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const Interval& interval = block.intervals[axis];
      const std::size_t inner = interval.splits() ? interval.last - interval.first - 1 : 0;
      const double share = std::fmod(0.5 + k * steps[axis], 1.0);
      place[axis] = interval.first +
                    (inner == 0 ? 0 : 1 + static_cast<std::size_t>(share * static_cast<double>(inner)));
    }
    cells.push_back(cell_at(planes, block.origin, place[0], place[1]));
  }
  return cells;
}

/// Calls `visit` with each cell of a block until `visit` returns false.
template <class Visit>
void visit_cells(const Planes& planes, const Block& block, const Visit& visit) {
  for (std::size_t j = block.intervals[1].first; j <= block.intervals[1].last; ++j) {
    for (std::size_t i = block.intervals[0].first; i <= block.intervals[0].last; ++i) {
      if (!visit(cell_at(planes, block.origin, i, j))) return;
    }
  }
}

bool uniform(const Planes& planes, const Block& block, std::span<const int> labels) {
  int found = unknown_label;
  bool equal = true;
  visit_cells(planes, block, [&](std::size_t cell) {
    const int label = labels[cell];
    if (label == unknown_label) return true;
    if (found == unknown_label) found = label;
    return equal = found == label;
  });
  return equal;
}

template <class Visit>
void visit_children(const Block& block, const Visit& visit) {
  for (const Interval& j : halves(block.intervals[1])) {
    for (const Interval& i : halves(block.intervals[0])) visit(Block{block.origin, {i, j}});
  }
}

void ask(const Planes& planes, const Block& block, std::span<const int> labels,
         std::vector<std::size_t>& wanted) {
  bool known = true;
  for (const std::size_t cell : corners(planes, block)) {
    if (labels[cell] != unknown_label) continue;
    wanted.push_back(cell);
    known = false;
  }
  if (!known || !block.splits() || uniform(planes, block, labels)) return;
  visit_children(block, [&](const Block& child) { ask(planes, child, labels, wanted); });
}

/// Calls `leaf` with every block that is not split further, and `split` with every block that is split and
/// its level.
template <class Leaf, class Split>
void visit_blocks(const Planes& planes, const Block& block, std::span<const int> labels, int level,
                  const Leaf& leaf, const Split& split) {
  if (!block.splits() || uniform(planes, block, labels)) return leaf(block);
  split(block, level);
  visit_children(block,
                 [&](const Block& child) { visit_blocks(planes, child, labels, level + 1, leaf, split); });
}

/// Interval of the lattice that holds an index; at the boundary of two intervals, the first one.
Interval interval_of(std::size_t index, std::size_t count, int levels) {
  const std::vector<Interval> intervals = lattice(count, levels);
  return *std::ranges::find_if(intervals, [&](const Interval& interval) { return index <= interval.last; });
}

/// Whether a cell is a probe of its block. Probes lie inside their block.
bool is_probe(const Planes& planes, const Refinement& refinement, std::size_t cell) {
  Block block;
  block.origin = cell;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto [count, stride] = planes.sides[axis];
    const std::size_t index = stride == 0 ? 0 : cell / stride % count;
    block.origin -= index * stride;
    block.intervals[axis] = interval_of(index, count, refinement.levels);
  }
  return std::ranges::count(probes(planes, block, refinement.probes), cell) > 0;
}

/// Number of halvings of the lattice after which the index is an end of an interval.
int level_on_axis(std::size_t index, std::size_t count, int levels) {
  int level = 0;
  for (Interval at = interval_of(index, count, levels); index != at.first && index != at.last; ++level)
    at = index <= at.middle() ? Interval{at.first, at.middle()} : Interval{at.middle(), at.last};
  return level;
}

}  // namespace

std::vector<std::size_t> wanted_cells(const Grid& grid, std::span<const int> labels) {
  const Planes planes = planes_of(grid);
  std::vector<std::size_t> wanted;
  visit_lattice(planes, grid.refinement->levels, [&](const Block& block) {
    for (const std::size_t cell : probes(planes, block, grid.refinement->probes)) {
      if (labels[cell] == unknown_label) wanted.push_back(cell);
    }
    ask(planes, block, labels, wanted);
  });
  std::ranges::sort(wanted);
  wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
  return wanted;
}

int refinement_level(const Grid& grid, std::size_t cell) {
  const Planes planes = planes_of(grid);
  if (is_probe(planes, *grid.refinement, cell)) return 0;
  int level = 0;
  for (const PlaneAxis& axis : planes.sides) {
    if (axis.count == 1) continue;
    const std::size_t index = cell / axis.stride % axis.count;
    level = std::max(level, level_on_axis(index, axis.count, grid.refinement->levels));
  }
  return level;
}

std::vector<int> painted_labels(const Grid& grid, std::span<const int> labels) {
  const Planes planes = planes_of(grid);
  std::vector<int> painted(labels.begin(), labels.end());
  const auto paint = [&](const Block& block) {
    const int label = labels[corners(planes, block).front()];
    if (!uniform(planes, block, labels)) return;  // smallest block: all its corners are computed
    visit_cells(planes, block, [&](std::size_t cell) {
      painted[cell] = label;
      return true;
    });
  };
  visit_lattice(planes, grid.refinement->levels, [&](const Block& block) {
    visit_blocks(planes, block, labels, 0, paint, [](const Block&, int) {});
  });
  return painted;
}

std::vector<std::size_t> shown_cells(const Grid& grid, std::span<const int> labels) {
  const std::vector<int> painted = painted_labels(grid, labels);
  std::map<int, std::size_t> latest;
  for (std::size_t cell = labels.size(); cell-- > 0;) {
    if (labels[cell] != unknown_label) latest[labels[cell]] = cell;
  }
  std::vector<std::size_t> shown;
  shown.reserve(labels.size());
  for (std::size_t cell = 0; cell < labels.size(); ++cell) {
    if (labels[cell] != unknown_label) latest[labels[cell]] = cell;
    shown.push_back(latest.at(painted[cell]));
  }
  return shown;
}

std::size_t island_bound(const Grid& grid) {
  const Planes planes = planes_of(grid);
  const auto [across, up] = planes.sides;
  std::vector<bool> met(cell_count(grid), false);
  visit_lattice(planes, grid.refinement->levels, [&](const Block& block) {
    for (const std::size_t cell : corners(planes, block)) met[cell] = true;
    for (const std::size_t cell : probes(planes, block, grid.refinement->probes)) met[cell] = true;
  });
  // Side of the largest empty square (without computed cells) whose last corner is the cell, computed from
  // the row before. For a single axis: number of consecutive cells that were not computed.
  std::size_t largest = 0;
  std::vector<std::size_t> before(across.count, 0), sides(across.count, 0);
  for (std::size_t j = 0; j < up.count; ++j) {
    for (std::size_t i = 0; i < across.count; ++i) {
      const std::size_t left = i == 0 ? 0 : sides[i - 1];
      const std::size_t least = up.count == 1      ? left
                                : i == 0 || j == 0 ? 0
                                                   : std::min({before[i - 1], before[i], left});
      sides[i] = met[cell_at(planes, 0, i, j)] ? 0 : least + 1;
      largest = std::max(largest, sides[i]);
    }
    std::swap(before, sides);
  }
  return largest + 1;
}

std::optional<double> boundary_exponent(const Grid& grid, std::span<const int> labels) {
  const Planes planes = planes_of(grid);
  const int levels = grid.refinement->levels;
  std::map<int, double> split_cells;  // number of cells by level
  visit_lattice(planes, levels, [&](const Block& lattice_block) {
    visit_blocks(
        planes, lattice_block, labels, 0, [](const Block&) {},
        [&](const Block& block, int level) {
          double cells = 1;
          for (const Interval& interval : block.intervals)
            cells *= static_cast<double>(std::max<std::size_t>(interval.last - interval.first, 1));
          split_cells[level] += cells;
        });
  });
  if (split_cells.size() < 3) return std::nullopt;
  // Slope of log2(area) over log2(size) = levels - level, by least squares.
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const auto& [level, cells] : split_cells) {
    const double size = levels - level, area = std::log2(cells);
    n += 1, x += size, y += area, xx += size * size, xy += size * area;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

}  // namespace rubsweep::sweep
