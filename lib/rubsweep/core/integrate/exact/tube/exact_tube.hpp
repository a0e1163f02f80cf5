#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "rubsweep/core/integrate/exact/modes/mode_cache.hpp"
#include "rubsweep/core/integrate/exact/tube/turn_tube.hpp"
#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::integrate::exact::tube {

/// The tubes of the turns of an orbit in a scene without pulse and impulses; the first turn starts at
/// `section` (as TurnReport::section). `disturbances[i]` is the matrix W of turn i, 2n x 2n, in the units of
/// a section. `norms[i]`, 2n x 2n, is the norm at the end of turn i, that is, the norm at the start of the
/// next turn (after the last turn: of the first one). The last `slow` columns of W, and rows of the norm, are
/// the slow part. `section` is replaced by the section at the end. Empty where the scene has annular stops or
/// friction that never saturates, where a turn has no closed form, where two changes of mode coincide, or
/// where a guard touches zero without crossing it.
std::optional<std::vector<TurnTube>> turn_tubes(const scene::Scene& scene, modes::ModeCache& modes,
                                                std::vector<double>& section,
                                                const std::vector<Eigen::MatrixXd>& disturbances,
                                                const std::vector<Eigen::MatrixXd>& norms,
                                                Eigen::Index slow = 0);

}  // namespace rubsweep::integrate::exact::tube
