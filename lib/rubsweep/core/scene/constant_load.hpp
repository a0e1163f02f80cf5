#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "rubsweep/core/scene/prepared_machine.hpp"

namespace rubsweep::scene {

/// Weight and static loads on every coordinate, in N or N m.
Eigen::VectorXd static_load_n(const PreparedMachine& prepared);

/// Constant load in a scene. It is zero where clearances are measured from the sag, because a linear
/// structure moves about its loaded position as it would move about its axis without the load.
Eigen::VectorXd constant_load_n(const PreparedMachine& prepared);

/// Displacements of the unloaded structure in the coordinates of a scene: zero, or the negative sag where
/// clearances are measured from the sag.
Eigen::VectorXd unloaded_position_m(const PreparedMachine& prepared,
                                    const structure::LinearSystem& structure);

/// Static displacement (x, y) of the rotor relative to the casing of a stop under weight and static loads, in
/// metres.
Eigen::Vector2d sag_m(const PreparedMachine& prepared, std::size_t stop);

}  // namespace rubsweep::scene
