#pragma once

#include <vector>

#include "branch_plane.hpp"
#include "curves_csv.hpp"
#include "rubsweep/analysis/branch/continuation/branch_point.hpp"
#include "rubsweep/core/response/motion/workspace.hpp"
#include "rubsweep/maps/sweep/study.hpp"

namespace rubsweep::apps {

/// Curves in the parameter plane from every event of the branches, each curve once. Events without a curve
/// are reported on stderr. `first`: the range of the first parameter.
std::vector<CurveFrom> curves_of(const std::vector<branch::continuation::Branch>& branches,
                                 const BranchPlane& plane, const branch::orbits::ParameterRange& first,
                                 const sweep::Study& study, int most_points,
                                 response::motion::Workspace& workspace);

}  // namespace rubsweep::apps
