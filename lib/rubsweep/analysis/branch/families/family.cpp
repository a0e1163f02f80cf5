#include "rubsweep/analysis/branch/families/family.hpp"

#include <algorithm>
#include <functional>
#include <set>
#include <utility>

#include "rubsweep/analysis/branch/orbits/scene_orbits.hpp"
#include "rubsweep/core/scene/build_scene.hpp"
#include "rubsweep/maps/batch/parallel_run.hpp"

namespace rubsweep::branch::families {
namespace {

thread_local response::motion::Workspace family_workspace;

struct Task {
  std::size_t from = 0, to = 0;
};

class Explorer {
 public:
  Explorer(const sweep::Study& study, int threads, const std::atomic<bool>& stop, FamilyRecords& records)
      : study_(study),
        prepared_(scene::prepare_machine(study.machine)),
        threads_(threads),
        stop_(stop),
        records_(records) {}

  std::vector<std::optional<CellOrbit>> settle(std::span<const std::size_t> cells) {
    std::vector<std::optional<CellOrbit>> orbits(cells.size());
    std::vector<std::size_t> unknown;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (const auto* orbit = records_.settled(cells[i]))
        orbits[i] = *orbit;
      else
        unknown.push_back(i);
    }
    for_each(
        unknown, [&](std::size_t i) { orbits[i] = settled(cells[i]); },
        [&](std::size_t i) { records_.keep_settled(cells[i], orbits[i]); });
    return orbits;
  }

  /// Explores a family in levels: the passages out of the cells of one level are independent of each other.
  Family explore(std::size_t seed, const CellOrbit& orbit) {
    Family family{seed, {{seed, orbit}}, {}, {}};
    std::vector<std::size_t> frontier{seed};
    while (!frontier.empty() && !stop_) {
      std::vector<Task> tasks;
      for (const std::size_t cell : frontier) {
        for (const std::size_t next : neighbours_of(study_.grid, cell))
          if (!family.orbits.contains(next)) tasks.push_back({cell, next});
      }
      const std::vector<Passage> passages = passages_of(tasks, family);
      frontier = take(tasks, passages, family);
    }
    return family;
  }

  bool same(std::size_t cell, const CellOrbit& a, const CellOrbit& b) {
    return same_orbit(study_, prepared_, cell, a, b, family_workspace);
  }

 private:
  void for_each(std::span<const std::size_t> which, const std::function<void(std::size_t)>& run,
                const std::function<void(std::size_t)>& on_finished) {
    batch::parallel_run(
        which.size(), threads_, [&](std::size_t i) { run(which[i]); },
        [&](std::size_t i) { on_finished(which[i]); }, stop_);
  }

  std::optional<CellOrbit> settled(std::size_t number) {
    const scene::Place place = sweep::place_of(study_.grid, number);
    const scene::Cell cell = scene::build_cell(prepared_, place.speed_hz, place.unbalance);
    if (!scene::can_run(cell.start)) return std::nullopt;
    const orbits::SettledStart start =
        orbits::settle_on_orbit(cell, study_.solver, study_.response, family_workspace);
    return stable_orbit(study_, prepared_, number, start, family_workspace);
  }

  std::vector<Passage> passages_of(const std::vector<Task>& tasks, const Family& family) {
    std::vector<Passage> passages(tasks.size());
    std::vector<std::size_t> unknown;
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      if (const Passage* passage = records_.passage(family.seed, tasks[i].from, tasks[i].to))
        passages[i] = *passage;
      else
        unknown.push_back(i);
    }
    for_each(
        unknown,
        [&](std::size_t i) {
          const auto [from, to] = tasks[i];
          passages[i] = pass(study_, prepared_, from, family.orbits.at(from), to, family_workspace);
        },
        [&](std::size_t i) { records_.keep_passage(family.seed, tasks[i].from, tasks[i].to, passages[i]); });
    return passages;
  }

  std::vector<std::size_t> take(const std::vector<Task>& tasks, const std::vector<Passage>& passages,
                                Family& family) {
    std::vector<std::size_t> added;
    for (std::size_t i = 0; i < tasks.size(); ++i) {
      const auto [from, to] = tasks[i];
      if (passages[i].arrived) {
        if (family.orbits.emplace(to, *passages[i].arrived).second) added.push_back(to);
      } else {
        family.ends.push_back(end_of(from, to, passages[i]));
      }
    }
    return added;
  }

  FamilyEnd end_of(std::size_t from, std::size_t to, const Passage& passage) const {
    const std::size_t speeds = study_.grid.speed_hz.size();
    FamilyEnd end{from, to, study_.grid.speed_hz[from % speeds], study_.grid.unbalance[from / speeds],
                  passage.kind};
    (from / speeds == to / speeds ? end.speed_hz : end.unbalance) = passage.parameter;
    return end;
  }

  const sweep::Study& study_;
  scene::PreparedMachine prepared_;
  int threads_;
  const std::atomic<bool>& stop_;
  FamilyRecords& records_;
};

/// Corner of a cell: (i, j) is the lower left corner of the cell with these indices.
using Corner = std::pair<long, long>;

/// Side between a cell inside and a cell outside the domain; null `end`: the side is on the map's edge.
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
    // Open lines, which begin at the edge of the map, come first; the remaining lines are closed.
    for (const bool open : {true, false}) {
      for (std::size_t i = 0; i < sides_.size(); ++i) {
        if (used_.contains(i) || sides_[i].end == nullptr) continue;
        if (!open || comes_from_the_edge_of_the_map(i)) follow(i);
      }
    }
    return std::move(lines_);
  }

 private:
  /// Adds the sides of a cell, counter-clockwise.
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

  /// Side that continues at the end of `side`. If two cells of the domain meet only in this corner, the
  /// result is the side that turns left and stays at the same cell.
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

const FamilyEnd* Family::end_between(std::size_t inside, std::size_t outside) const {
  const auto found = std::ranges::find_if(
      ends, [&](const FamilyEnd& end) { return end.inside == inside && end.outside == outside; });
  return found == ends.end() ? nullptr : &*found;
}

std::vector<std::size_t> neighbours_of(const sweep::Grid& grid, std::size_t cell) {
  const std::size_t speeds = grid.speed_hz.size(), speed = cell % speeds, unbalance = cell / speeds;
  std::vector<std::size_t> neighbours;
  if (speed > 0) neighbours.push_back(cell - 1);
  if (speed + 1 < speeds) neighbours.push_back(cell + 1);
  if (unbalance > 0) neighbours.push_back(cell - speeds);
  if (unbalance + 1 < grid.unbalance.size()) neighbours.push_back(cell + speeds);
  return neighbours;
}

Families families_of(const sweep::Study& study, std::span<const std::size_t> proven, int threads,
                     const std::atomic<bool>& stop, FamilyRecords& records) {
  Explorer explorer(study, threads, stop, records);
  Families families;
  const auto settled = explorer.settle(proven);
  std::vector<bool> known(proven.size(), false);
  for (std::size_t i = 0; i < proven.size() && !stop; ++i) {
    if (known[i]) continue;
    if (!settled[i]) {
      families.not_followed.push_back(proven[i]);
      continue;
    }
    Family family = explorer.explore(proven[i], *settled[i]);
    for (std::size_t k = i; k < proven.size(); ++k) {
      const auto orbit = family.orbits.find(proven[k]);
      if (known[k] || !settled[k] || orbit == family.orbits.end()) continue;
      known[k] = explorer.same(proven[k], orbit->second, *settled[k]);
      if (known[k]) family.reached.push_back(proven[k]);
    }
    families.list.push_back(std::move(family));
  }
  return families;
}

std::vector<OutlineLine> outline_of(const sweep::Grid& grid, const Family& family) {
  return Tracer(grid, family).trace();
}

}  // namespace rubsweep::branch::families
