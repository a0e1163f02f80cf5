#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "rubsweep/core/integrate/exact/modes/mode_cache.hpp"
#include "rubsweep/core/integrate/exact/tube/turn_tube.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::integrate::exact::tube {

/// The tubes of the turns of an orbit, the first of which starts at `section` (as TurnReport::section), of a
/// scene without pulse and impulses. `disturbances[i]` is W of turn i, 2n x 2n, in the units of a section,
/// and `norms[i]` 2n x 2n on its first section: at its end counts the next one, behind the last the first.
/// The last `slow` columns of the one and rows of the other are the slow part. Replaces `section` by the one
/// at the end. Empty where the scene has annular stops or friction that never saturates, where a turn has no
/// closed form, where two changes of mode happen at one instant, or where a guard is at zero without crossing
/// it.
std::optional<std::vector<TurnTube>> turn_tubes(const scene::Scene& scene, modes::ModeCache& modes,
                                                std::vector<double>& section,
                                                const std::vector<Eigen::MatrixXd>& disturbances,
                                                const std::vector<Eigen::MatrixXd>& norms,
                                                Eigen::Index slow = 0);

}  // namespace rubsweep::integrate::exact::tube
