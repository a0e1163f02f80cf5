#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::scene {

/// Displacement (x, y) of the observed point per unit of each coordinate; it also maps the velocities.
inline const Eigen::Matrix<double, 2, Eigen::Dynamic>& observed(const Scene& scene) {
  return scene.structure.points[static_cast<std::size_t>(scene.observed_point)].map;
}

}  // namespace rubsweep::scene
