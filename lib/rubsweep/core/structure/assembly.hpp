#pragma once

#include <optional>
#include <vector>

#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/core/model/stop.hpp"
#include "rubsweep/core/structure/linear_system.hpp"
#include "rubsweep/core/structure/tabled_support.hpp"

namespace rubsweep::structure {

/// A rotor and its casings as one linear system. Point numbers are indices into `system.points`.
struct Assembly {
  LinearSystem system;          ///< system without the terms that depend on the speed
  Eigen::MatrixXd gyroscopic;   ///< n x n or empty: at a speed w the damping is system.damping + w gyroscopic
  Eigen::MatrixXd circulatory;  ///< n x n or empty: with rotating damping the stiffness is system.stiffness +
                                ///< w circulatory, unsymmetric
  std::vector<TabledSupport> tables;  ///< supports whose coefficients depend on the speed: see system_at
  std::optional<Eigen::Index> twist;  ///< index of the torsion coordinate: angle between rotor and drive
  double unbalance_inertia_kg = 0;    ///< polar inertia per e^2 that an eccentricity e adds
  Eigen::VectorXcd bow_n;     ///< n or empty: at any speed w, a bow and misaligned couplings give the force
                              ///< Re(bow_n e^{i w t})
  Eigen::VectorXcd second_n;  ///< n or empty: at any speed w, asymmetric couplings give the force Re(second_n
                              ///< e^{2 i w t})
  Eigen::VectorXd static_n;   ///< n or empty: constant loads in addition to the weight
  std::vector<ImpulseTrain> impulses;  ///< impulses of faulty bearings
  std::vector<int> rotor_points;       ///< index of each stop's point
  std::vector<std::optional<int>>
      casing_points;                    ///< index of each casing's point; empty: rigid casing, no state
  std::vector<int> sensor_points;       ///< index of each sensor's point
  int observed_point = 0;               ///< point whose motion is classified
  int kick_point = 0;                   ///< point of the first kick; those of further kicks of a kit follow
  std::vector<double> contact_mass_kg;  ///< rotor mass at each stop, for a restitution
};

/// Adds a body on an isotropic spring, with coordinates `first` (x) and `first + 1` (y), and its point.
void add_body(LinearSystem& system, Eigen::Index first, double mass_kg, double stiffness_n_per_m,
              double damping_ratio);

/// Throws ConfigError where a number of the assembly is not finite, or its mass matrix is singular or
/// indefinite within rounding, so that no motion could be computed.
void refuse_unusable(const Assembly& assembly);

/// The linear system of an assembly at one speed of the shaft. It includes gyroscopic moments, rotating
/// damping, and the coefficients of supports from tables, which must contain the speed.
LinearSystem system_at(const Assembly& assembly, double speed_rad_per_s);

/// Jeffcott rotor and the moving casings among `casings` (one entry per stop). Coordinates: x and y of the
/// rotor, then x and y of each moving casing in the order of the stops. Mass, damping and stiffness are
/// diagonal; the circulatory matrix of rotating damping couples x and y of the rotor. The unbalance turns
/// from +x towards +y; at t = 0 it points along +x.
Assembly assemble_jeffcott(const model::JeffcottRotor& rotor,
                           const std::vector<std::optional<model::Casing>>& casings);

}  // namespace rubsweep::structure
