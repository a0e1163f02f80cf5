#pragma once

#include <optional>
#include <vector>

#include "rubsweep/core/model/machine.hpp"
#include "rubsweep/core/model/stop.hpp"
#include "rubsweep/core/structure/linear_system.hpp"
#include "rubsweep/core/structure/tabled_support.hpp"

namespace rubsweep::structure {

/// A rotor and its casings as one linear system; the numbers index `system.points`.
struct Assembly {
  LinearSystem system;          ///< system without what depends on the speed
  Eigen::MatrixXd gyroscopic;   ///< n x n or empty: at a speed w the damping is system.damping + w gyroscopic
  Eigen::MatrixXd circulatory;  ///< n x n or empty: damping that turns with the shaft makes the stiffness
                                ///< system.stiffness + w circulatory, which is not symmetric
  std::vector<TabledSupport> tables;  ///< supports that follow the speed: see system_at
  std::optional<Eigen::Index> twist;  ///< the coordinate of torsion: angle between rotor and drive
  double unbalance_inertia_kg = 0;    ///< times e^2: what an eccentricity e adds to the polar inertia
  Eigen::VectorXcd bow_n;  ///< n or empty: a residual bow and couplings out of line force Re(bow_n e^{i w t})
                           ///< at any speed w
  Eigen::VectorXcd second_n;  ///< n or empty: couplings of unequal stiffness force Re(second_n e^{2 i w t})
                              ///< at any speed w
  Eigen::VectorXd static_n;   ///< n or empty: loads beside the weight that do not change
  std::vector<ImpulseTrain> impulses;  ///< impulses of faulty bearings
  std::vector<int> rotor_points;       ///< point of each stop
  std::vector<std::optional<int>>
      casing_points;               ///< point of each stop's casing; empty: rigid casing, no state
  std::vector<int> sensor_points;  ///< point of each sensor
  int observed_point = 0;          ///< whose motion is classified
  int kick_point = 0;
  std::vector<double> contact_mass_kg;  ///< rotor mass of each stop behind a restitution
};

/// Adds an isotropic mass on a spring at coordinates `first` (x) and `first + 1` (y), and the point that it
/// is.
void add_body(LinearSystem& system, Eigen::Index first, double mass_kg, double stiffness_n_per_m,
              double damping_ratio);

/// Throws ConfigError where some number of the assembly is not finite, or its mass matrix is not positive
/// definite to rounding: no motion of it could be computed.
void refuse_unusable(const Assembly& assembly);

/// The linear system of an assembly at one speed of the shaft: gyroscopic moments, damping that turns with
/// the shaft, and supports by their tables, which must reach the speed.
LinearSystem system_at(const Assembly& assembly, double speed_rad_per_s);

/// Jeffcott rotor and the moving ones among `casings` (one entry per stop). Coordinates: x and y of the
/// rotor, then x and y of every moving casing in the order of the stops; mass, damping and stiffness
/// diagonal, the circulatory matrix of rotating damping between x and y of the rotor. The unbalance turns
/// from +x towards +y: at t = 0 it points along +x.
Assembly assemble_jeffcott(const model::JeffcottRotor& rotor,
                           const std::vector<std::optional<model::Casing>>& casings);

}  // namespace rubsweep::structure
