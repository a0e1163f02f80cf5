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

/// A wall between two points of the structure. The slip is d' . t + surface speed, with d and t as at
/// contact::Wall.
struct Contact {
  int rotor_point = 0;
  std::optional<int> casing_point;  ///< empty: the casing does not move
  contact::Wall wall;               ///< in metres
  double clearance_m = 0;           ///< >= 0
  double stiffness_n_per_m = 0;
  double damping_ns_per_m = 0;
  model::Friction friction;
  double surface_speed_m_per_s = 0;  ///< R omega
  /// Law in place of stiffness (its secant then) and damping (0); null: these two, the clamped ElastoGap law.
  std::shared_ptr<const contact::CurvedLaw> law{};
};

/// Half-sine force pulse: F(t) = force_n sin(pi (t + elapsed_s) / duration_s) as long as t + elapsed_s is
/// between 0 and duration_s, nothing before and after. The kick of a configuration is one that starts at
/// t = 0.
struct Pulse {
  Eigen::VectorXd direction;  ///< n: generalised force per newton
  double force_n = 0;
  double duration_s = 0;
  double elapsed_s = 0;  ///< how long before t = 0 it started; below 0: it starts at t = -elapsed_s
};

/// Torsion: one coordinate is the angle in radians by which the rotor is ahead of its drive, which turns at
/// the scene's speed. All that turns with the rotor then stands at phi = speed t + angle: the numbers below
/// take the place of Scene::harmonic_n, and turn the rotor in their turn. The adaptive solver alone knows of
/// it.
struct Twist {
  Eigen::Index coordinate = 0;           ///< of q; on the diagonal of the structure: polar inertia and drive
  Eigen::VectorXcd unbalance_kg_m;       ///< n: forces Re(unbalance (phi'^2 - i phi'') e^{i phi})
  Eigen::VectorXcd bow_n;                ///< n or empty: forces Re(bow e^{i phi})
  Eigen::MatrixXd gyroscopic;            ///< n x n or empty: part of structure.damping per rad/s of the shaft
  Eigen::MatrixXd circulatory;           ///< n x n or empty: the same of structure.stiffness
  double unbalance_inertia_kg_m2 = 0;    ///< contribution of the eccentric masses to the polar inertia
  std::vector<double> contact_radius_m;  ///< of each contact: lever of its friction about the shaft's axis
};

/// All that one run simulates, at one speed: a linear structure, what drives it, and the contacts between its
/// points. The solvers know nothing else; a new rotor or a new stop changes what fills this, not what reads
/// it. What drives it is the sum of a force that turns with the shaft, perhaps one of twice its frequency, a
/// constant one, any number of pulses (forces over a while, which may overlap) and any number of impulse
/// trains (jumps of the velocities).
struct Scene {
  structure::LinearSystem structure;
  std::vector<Contact> contacts;
  double speed_rad_per_s = 0;            ///< > 0; one revolution lasts 2 pi / speed
  Eigen::VectorXcd harmonic_n;           ///< n: force Re(harmonic_n e^{i speed t})
  Eigen::VectorXcd second_harmonic_n{};  ///< n or empty: force Re(second_harmonic_n e^{2 i speed t})
  Eigen::VectorXd constant_n;            ///< n: force that does not change
  std::vector<Pulse> pulses;
  std::vector<structure::ImpulseTrain> impulses;
  long elapsed_revolutions = 0;    ///< of the impulse trains at t = 0
  Eigen::VectorXd displacement_m;  ///< n: q(0)
  Eigen::VectorXd velocity_m_per_s;
  std::optional<Twist> twist{};
  int observed_point = 0;     ///< whose motion is sampled and classified: the rotor
  double length_scale_m = 0;  ///< > 0: what "small" is measured against, the first stop's clearance

  double period_s() const { return 2 * std::numbers::pi / speed_rad_per_s; }
};

/// Displacement (x, y) of the observed point per unit of each coordinate: its velocity by the velocities,
/// too.
inline const Eigen::Matrix<double, 2, Eigen::Dynamic>& observed(const Scene& scene) {
  return scene.structure.points[static_cast<std::size_t>(scene.observed_point)].map;
}

}  // namespace rubsweep::scene
