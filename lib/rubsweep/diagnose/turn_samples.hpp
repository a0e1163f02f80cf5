#pragma once

#include <complex>
#include <vector>

#include "rubsweep/integrate/run/turn.hpp"
#include "rubsweep/scene/scene.hpp"

namespace rubsweep::diagnose {

/// Adds the samples of a turn at the observed point, x + iy in metres.
void add_samples(const scene::Scene& scene, const integrate::run::TurnReport& turn,
                 std::vector<std::complex<double>>& displacement_m);

}  // namespace rubsweep::diagnose
