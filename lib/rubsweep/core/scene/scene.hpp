#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <memory>
#include <numbers>
#include <optional>
#include <vector>

#include "rubsweep/core/contact/curved_law.hpp"
#include "rubsweep/core/contact/wall.hpp"
#include "rubsweep/core/model/friction.hpp"
#include "rubsweep/core/structure/linear_system.hpp"

namespace rubsweep::scene {

/// A wall between two points of the structure. The slip speed is d' . t + surface speed, with d and t as
/// defined at contact::Wall.
struct Contact {
  int rotor_point = 0;
  std::optional<int> casing_point;  ///< empty: the casing does not move
  contact::Wall wall;               ///< geometry of the wall in metres
  double clearance_m = 0;           ///< >= 0
  double stiffness_n_per_m = 0;
  double damping_ns_per_m = 0;
  model::Friction friction;
  double surface_speed_m_per_s = 0;  ///< R omega
  /// Law used in place of stiffness (then its secant) and damping (then 0); null: the clamped ElastoGap law
  /// with these two.
  std::shared_ptr<const contact::CurvedLaw> law{};
};

/// Half-sine force pulse: F(t) = force_n sin(pi (t + elapsed_s) / duration_s) while t + elapsed_s is between
/// 0 and duration_s, zero before and after. The kick of a configuration is a pulse that starts at t = 0.
struct Pulse {
  Eigen::VectorXd direction;  ///< n: generalised force per newton
  double force_n = 0;
  double duration_s = 0;
  double elapsed_s = 0;  ///< time from its start to t = 0; below 0: it starts later
};

/// Torsion: one coordinate is the angle in radians by which the rotor leads its drive, which turns at the
/// scene's speed. Everything that turns with the rotor is then at the angle phi = speed t + coordinate: the
/// members below replace Scene::harmonic_n, and also act back on the rotation. Only the adaptive solver
/// supports torsion.
struct Twist {
  Eigen::Index coordinate = 0;           ///< index in q; polar inertia and drive are on its diagonal
  Eigen::VectorXcd unbalance_kg_m;       ///< n: forces Re(unbalance (phi'^2 - i phi'') e^{i phi})
  Eigen::VectorXcd bow_n;                ///< n or empty: forces Re(bow e^{i phi})
  Eigen::MatrixXd gyroscopic;            ///< n x n or empty: part of structure.damping per rad/s of speed
  Eigen::MatrixXd circulatory;           ///< n x n or empty: part of structure.stiffness per rad/s of speed
  double unbalance_inertia_kg_m2 = 0;    ///< polar inertia due to the eccentric masses
  std::vector<double> contact_radius_m;  ///< radius at each contact: lever of its friction about the axis
};

/// All data of one run at one speed: a linear structure, its excitation, and the contacts between its points.
/// The solvers use nothing else, so that a new kind of rotor or stop only changes the code that fills this
/// struct. The excitation is the sum of a force that turns with the shaft, an optional one at twice its
/// frequency, a constant one, any number of pulses (forces of limited duration, which may overlap) and any
/// number of impulse trains (jumps of the velocities).
struct Scene {
  structure::LinearSystem structure;
  std::vector<Contact> contacts;
  double speed_rad_per_s = 0;            ///< > 0; one revolution lasts 2 pi / speed
  Eigen::VectorXcd harmonic_n;           ///< n: force Re(harmonic_n e^{i speed t})
  Eigen::VectorXcd second_harmonic_n{};  ///< n or empty: force Re(second_harmonic_n e^{2 i speed t})
  Eigen::VectorXd constant_n;            ///< n: constant force
  std::vector<Pulse> pulses;
  std::vector<structure::ImpulseTrain> impulses;
  long elapsed_revolutions = 0;    ///< number of revolutions that the impulse trains have completed at t = 0
  Eigen::VectorXd displacement_m;  ///< n: displacements q(0)
  Eigen::VectorXd velocity_m_per_s;
  std::optional<Twist> twist{};
  int observed_point = 0;     ///< point whose motion is sampled and classified: the rotor
  double length_scale_m = 0;  ///< > 0: reference for "small" displacements, the clearance of the first stop

  double period_s() const { return 2 * std::numbers::pi / speed_rad_per_s; }
};

/// Displacement (x, y) of the observed point per unit of each coordinate; it also maps the velocities.
inline const Eigen::Matrix<double, 2, Eigen::Dynamic>& observed(const Scene& scene) {
  return scene.structure.points[static_cast<std::size_t>(scene.observed_point)].map;
}

}  // namespace rubsweep::scene
