#include "rubsweep/analysis/branch/families/passage.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "rubsweep/analysis/branch/continuation/follow.hpp"
#include "rubsweep/analysis/branch/continuation/orbit_newton.hpp"
#include "rubsweep/core/scene/build_scene.hpp"

namespace rubsweep::branch::families {
namespace {

/// Indices of a cell on the axes of speed and unbalance.
struct GridPlace {
  std::size_t speed = 0, unbalance = 0;
};

GridPlace place_in(const sweep::Grid& grid, std::size_t cell) {
  return {cell % grid.speed_hz.size(), cell / grid.speed_hz.size()};
}

std::optional<scene::Scene> scene_of(const scene::PreparedMachine& prepared, double speed_hz,
                                     const scene::Unbalance& unbalance) {
  if (!(speed_hz > 0)) return std::nullopt;
  scene::Cell cell = scene::build_cell(prepared, speed_hz, unbalance);
  if (!scene::can_run(cell.start)) return std::nullopt;
  return std::move(cell.scene);
}

double length_of(const std::vector<double>& axis) {
  const auto [low, high] = std::ranges::minmax(axis);
  return high > low ? high - low : std::max(std::abs(high), 1e-300);
}

struct Way {
  orbits::OrbitProblem problem;
  double from = 0, to = 0;
};

/// Way from one cell to another along one axis; if the cells are equal, along the axis of speed.
Way way_between(const sweep::Study& study, const scene::PreparedMachine& prepared, std::size_t cell,
                std::size_t neighbour, orbits::Closing closing, int order,
                response::motion::Workspace& workspace) {
  const sweep::Grid& grid = study.grid;
  const GridPlace a = place_in(grid, cell), b = place_in(grid, neighbour);
  const bool along_speed = a.unbalance == b.unbalance;
  const double speed_hz = grid.speed_hz[a.speed], unbalance = grid.unbalance[a.unbalance];
  const orbits::SceneFamily family = [&prepared, &grid, along_speed, speed_hz, unbalance](double p) {
    return along_speed ? scene_of(prepared, p, sweep::unbalance_of(grid, unbalance))
                       : scene_of(prepared, speed_hz, sweep::unbalance_of(grid, p));
  };
  const std::vector<double>& axis = along_speed ? grid.speed_hz : grid.unbalance;
  Way way{orbits::closed_orbits(closing, family, order, study.solver, workspace.modes),
          along_speed ? speed_hz : unbalance,
          along_speed ? grid.speed_hz[b.speed] : grid.unbalance[b.unbalance]};
  // The range also extends behind the start, where a branch may return after a fold.
  const double behind = way.from + (way.from - way.to);
  way.problem.low = std::min(behind, way.to);
  way.problem.high = std::max(behind, way.to);
  way.problem.parameter_scale = length_of(axis);
  return way;
}

CellOrbit orbit_of(const continuation::BranchPoint& point, orbits::Closing closing, int order) {
  return {order, point.facts.hits, point.state, closing};
}

continuation::FollowOptions options_of_a_passage() {
  continuation::FollowOptions options;
  options.first_step = 2e-3;
  options.longest_step = 0.05;
  options.most_points = 500;
  options.stop_at_first_change = true;
  options.every_graze = false;
  return options;
}

/// Limit on the points of a second attempt, for a long branch between two cells.
constexpr int patient_points = 5000;

constexpr double same = 1e-6;

/// Compares the facts that are the same at all maxima of an oval.
bool same_oval(const orbits::OrbitFacts& a, const orbits::OrbitFacts& b) {
  const auto agree = [](double x, double y) {
    return std::abs(x - y) <= same * std::max(std::abs(x), std::abs(y));
  };
  return a.hits == b.hits && agree(a.period_turns, b.period_turns) &&
         agree(a.peak_displacement_m, b.peak_displacement_m) &&
         agree(a.peak_contact_force_n, b.peak_contact_force_n);
}

/// Whether following failed, rather than the orbit ending.
bool given_up(continuation::Ending ending) {
  return ending == continuation::Ending::failed || ending == continuation::Ending::step_too_small ||
         ending == continuation::Ending::singular || ending == continuation::Ending::point_limit;
}

continuation::HalfBranch follow_the_way(const Way& way, const continuation::BranchPoint& start,
                                        const continuation::FollowOptions& options) {
  return continuation::follow(way.problem, way.to > way.from ? start : turned_about(start), options);
}

/// Second attempt with another scale of the parameter: the length 1 is the way between the cells, not the
/// whole axis. With the first scale, turns of the branch behind a graze may be too small to be found (below
/// 1e-9 of the axis).
continuation::HalfBranch follow_patiently(Way way, const CellOrbit& orbit, continuation::HalfBranch first) {
  continuation::FollowOptions options = options_of_a_passage();
  options.most_points = patient_points;
  way.problem.parameter_scale = std::abs(way.to - way.from);
  const auto start =
      continuation::orbit_from(way.problem, orbit.state, way.from);  // the tangent depends on the scale
  if (!start) return first;
  continuation::HalfBranch second = follow_the_way(way, *start, options);
  return given_up(second.ending) ? std::move(first) : std::move(second);
}

}  // namespace

std::optional<CellOrbit> stable_orbit(const sweep::Study& study, const scene::PreparedMachine& prepared,
                                      std::size_t cell, const orbits::SettledStart& settled,
                                      response::motion::Workspace& workspace) {
  if (!settled.order) return std::nullopt;
  const Way way = way_between(study, prepared, cell, cell, settled.closing, *settled.order, workspace);
  const auto point = continuation::orbit_from(way.problem, settled.state, way.from);
  if (!point || !point->stable() || !point->facts.touched) return std::nullopt;
  return orbit_of(*point, settled.closing, *settled.order);
}

Passage pass(const sweep::Study& study, const scene::PreparedMachine& prepared, std::size_t cell,
             const CellOrbit& orbit, std::size_t neighbour, response::motion::Workspace& workspace) {
  const Way way = way_between(study, prepared, cell, neighbour, orbit.closing, orbit.order, workspace);
  const auto start = continuation::orbit_from(way.problem, orbit.state, way.from);
  if (!start || !start->stable()) return {{}, to_string(continuation::EventKind::stability), way.from};
  continuation::HalfBranch half = follow_the_way(way, *start, options_of_a_passage());
  if (given_up(half.ending)) half = follow_patiently(way, orbit, std::move(half));
  const continuation::BranchPoint& last = half.points.back();
  if (half.ending == continuation::Ending::left_range && last.parameter == way.to)
    return {orbit_of(last, orbit.closing, orbit.order), {}, way.to};
  const bool by_event = half.ending == continuation::Ending::first_change && !half.events.empty();
  if (half.ending == continuation::Ending::off_the_walls)
    return {{}, to_string(continuation::EventKind::graze), last.parameter};
  return {{}, by_event ? to_string(half.events.back().kind) : to_string(half.ending), last.parameter};
}

bool same_orbit(const sweep::Study& study, const scene::PreparedMachine& prepared, std::size_t cell,
                const CellOrbit& orbit, const CellOrbit& other, response::motion::Workspace& workspace) {
  if (orbit.closing != other.closing || orbit.order != other.order) return false;
  const Way way = way_between(study, prepared, cell, cell, orbit.closing, orbit.order, workspace);
  const auto facts = way.problem.facts(way.from, orbit.state);
  if (!facts) return false;
  if (orbit.closing == orbits::Closing::in_the_turning_frame) {
    const auto others = way.problem.facts(way.from, other.state);
    return others && same_oval(*facts, *others);
  }
  return std::ranges::any_of(facts->sections, [&](const Eigen::VectorXd& section) {
    return (section - other.state).cwiseAbs().maxCoeff() < same;
  });
}

}  // namespace rubsweep::branch::families
