#pragma once

#include <vector>

#include "branch_plane.hpp"
#include "curves_csv.hpp"
#include "rubsweep/analysis/branch/continuation/branch_point.hpp"
#include "rubsweep/core/response/motion/workspace.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::apps {

/// A curve in the plane from every event of the branches, each curve once. Says on stderr which events have
/// none. `first`: the range of the first parameter.
std::vector<CurveFrom> curves_of(const std::vector<branch::continuation::Branch>& branches,
                                 const BranchPlane& plane, const branch::orbits::ParameterRange& first,
                                 const sweep::Study& study, int most_points,
                                 response::motion::Workspace& workspace);

}  // namespace rubsweep::apps
