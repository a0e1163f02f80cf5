#pragma once

#include <Eigen/Core>

#include "rubsweep/core/integrate/run/state_scale.hpp"

namespace rubsweep::response::rotating {

inline Eigen::VectorXd initial_state(const scene::Scene& scene) {
  const auto state = integrate::run::scaled_initial_state(scene);
  return Eigen::Map<const Eigen::VectorXd>(state.data(), static_cast<Eigen::Index>(state.size()));
}

}  // namespace rubsweep::response::rotating
