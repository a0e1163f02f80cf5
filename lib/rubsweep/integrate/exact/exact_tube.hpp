#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "rubsweep/integrate/exact/mode_cache.hpp"
#include "rubsweep/integrate/exact/turn_tube.hpp"
#include "rubsweep/scene/scene.hpp"

namespace rubsweep::integrate::exact {

/// The tube of the turn that starts at `section` (as TurnReport::section) of a scene without pulse and
/// impulses. `disturbances` is W, 2n x 2n, in the units of a section; `end_norm` 2n x 2n on a section. The
/// last `slow` columns of the one and rows of the other are the slow part. Replaces `section` by the one at
/// the end. Empty where the scene has annular stops or friction that never saturates, where the turn has no
/// closed form, where two changes of mode happen at one instant, or where a guard is at zero without crossing
/// it.
std::optional<TurnTube> turn_tube(const scene::Scene& scene, ModeCache& modes, std::vector<double>& section,
                                  const Eigen::MatrixXd& disturbances, const Eigen::MatrixXd& end_norm,
                                  Eigen::Index slow = 0);

}  // namespace rubsweep::integrate::exact
