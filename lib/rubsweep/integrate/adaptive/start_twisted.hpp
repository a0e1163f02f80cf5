#pragma once

#include "rubsweep/integrate/run/options.hpp"
#include "rubsweep/integrate/run/turn.hpp"
#include "rubsweep/scene/scene.hpp"

namespace rubsweep::integrate::adaptive {

/// As start_adaptive, for a scene with torsion.
run::Cursor start_twisted(const scene::Scene& scene, const run::SolverOptions& options);

}  // namespace rubsweep::integrate::adaptive
