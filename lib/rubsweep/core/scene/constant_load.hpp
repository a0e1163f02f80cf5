#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "rubsweep/core/scene/prepared_machine.hpp"

namespace rubsweep::scene {

/// Weight and static loads on every coordinate, in N or N m.
Eigen::VectorXd static_load_n(const PreparedMachine& prepared);

/// The part of it that a scene has. Clearances that count from the sag have none: a linear structure moves
/// about the position where constant forces leave it as it would about its axis without them.
Eigen::VectorXd constant_load_n(const PreparedMachine& prepared);

/// Displacements of a structure on which no force has acted yet, as a scene counts them: zero, or where
/// clearances count from the sag, that sag backwards.
Eigen::VectorXd unloaded_position_m(const PreparedMachine& prepared,
                                    const structure::LinearSystem& structure);

/// How far weight and static loads move the rotor relative to the casing of a stop, at rest, in x and y.
Eigen::Vector2d sag_m(const PreparedMachine& prepared, std::size_t stop);

}  // namespace rubsweep::scene
