#include "rubbranch_curves.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "rubsweep/analysis/branch/curves/follow_curve.hpp"
#include "shared/program.hpp"

namespace rubsweep::apps {
namespace {

using branch::continuation::EventKind;

/// Where a branch ends on the branch of half its period, the event is a period doubling of that branch.
branch::continuation::BranchEvent with_its_own_period(branch::continuation::BranchEvent event, int& order) {
  if (event.kind == EventKind::period_halving) {
    event.kind = EventKind::period_doubling;
    order /= 2;
  }
  return event;
}

}  // namespace

std::vector<CurveFrom> curves_of(const std::vector<branch::continuation::Branch>& branches,
                                 const BranchPlane& plane, const branch::orbits::ParameterRange& first,
                                 const sweep::Study& study, int most_points,
                                 response::motion::Workspace& workspace) {
  std::vector<CurveFrom> curves;
  branch::curves::CurveOptions options;
  options.most_points = most_points;
  std::size_t row = 0;
  for (std::size_t i = 0; i < branches.size(); ++i) {
    for (const branch::continuation::BranchEvent& found : branches[i].events) {
      const std::size_t this_row = row++;
      int order = branches[i].order;
      const branch::continuation::BranchEvent event = with_its_own_period(found, order);
      const double parameter = event.point.parameter;
      branch::orbits::PlaneOrbits orbits =
          branch::orbits::scene_plane_orbits(plane.scenes, order, study.solver, workspace.modes);
      orbits.first = first;
      orbits.second = plane.second;
      const auto start =
          branch::curves::curve_start(orbits, event, {parameter, plane.second_on_branch(parameter), 0});
      if (!start) {
        say(fmt::format("rubbranch: no curve starts from the {} at {:.10g}\n", to_string(found.kind),
                        parameter));
        continue;
      }
      const bool known = std::ranges::any_of(curves, [&](const CurveFrom& other) {
        return other.curve.kind == event.kind && other.curve.order == order &&
               branch::curves::lies_on(start->system, other.curve, start->point);
      });
      if (!known)
        curves.push_back({branch::curves::follow_curve(start->system, start->point, options), i, this_row});
    }
  }
  return curves;
}

}  // namespace rubsweep::apps
