#pragma once

#include <Eigen/Core>
#include <vector>

#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::integrate::run {

/// A part of a force that repeats twice per revolution: top_n sin(4 pi (turns + turns_ahead)). The solvers
/// treat it as a half-sine pulse that never ends; its time restarts in every revolution.
struct HarmonicPart {
  Eigen::VectorXd top_n;   ///< amplitude as generalised forces, in newtons
  double turns_ahead = 0;  ///< turns of the shaft from the start of its sine to the start of a revolution
};

/// Parts of the second harmonic of a scene: its cosine and its sine, or none.
std::vector<HarmonicPart> second_harmonic(const scene::Scene& scene);

}  // namespace rubsweep::integrate::run
