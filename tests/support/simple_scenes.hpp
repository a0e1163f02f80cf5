#pragma once

#include <numbers>
#include <optional>

#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::test {

/// One mass on an isotropic spring and damper, at rest at the origin, without excitation; one revolution
/// lasts `revolution_s`. Tests add what they need; no configuration file is involved.
inline scene::Scene one_mass_scene(double mass_kg, double stiffness_n_per_m, double damping_ns_per_m,
                                   double revolution_s, double length_scale_m) {
  scene::Scene scene;
  auto& system = scene.structure;
  system.mass = mass_kg * Eigen::MatrixXd::Identity(2, 2);
  system.stiffness = stiffness_n_per_m * Eigen::MatrixXd::Identity(2, 2);
  system.damping = damping_ns_per_m * Eigen::MatrixXd::Identity(2, 2);
  system.unbalance_kg = Eigen::VectorXcd::Zero(2);
  system.weight_kg = Eigen::Vector2d(0, -mass_kg);
  system.points.push_back({Eigen::Matrix<double, 2, Eigen::Dynamic>::Identity(2, 2)});
  scene.speed_rad_per_s = 2 * std::numbers::pi / revolution_s;
  scene.harmonic_n = Eigen::VectorXcd::Zero(2);
  scene.constant_n = Eigen::VectorXd::Zero(2);
  scene.displacement_m = scene.velocity_m_per_s = Eigen::VectorXd::Zero(2);
  scene.length_scale_m = length_scale_m;
  return scene;
}

/// Rigid frictionless wall across the x axis with the normal (sign, 0).
inline scene::Contact wall_across_x(double sign, double clearance_m, double stiffness_n_per_m,
                                    double damping_ns_per_m) {
  scene::Contact wall;
  wall.wall = contact::FlatWall{{sign, 0}};
  wall.clearance_m = clearance_m;
  wall.stiffness_n_per_m = stiffness_n_per_m;
  wall.damping_ns_per_m = damping_ns_per_m;
  return wall;
}

}  // namespace rubsweep::test
