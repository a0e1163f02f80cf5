#pragma once

#include <Eigen/Core>

#include "rubsweep/scene/scene.hpp"

namespace rubsweep::trace {

/// Energy of a vibration at one instant, and the power of all that changes it: between two instants without
/// an impulse, kinetic + elastic + contact grows by the integral of the four powers. It is the energy of the
/// coordinates, which does not count the rotation of the shaft: friction gives the vibration what the drive
/// puts in beyond what the slip turns into heat.
struct Energy {
  double kinetic_j = 0;          ///< v M v / 2
  double elastic_j = 0;          ///< q K q / 2 of rotor, supports and casings; weight is a force
  double contact_j = 0;          ///< in the springs of the contacts
  double forcing_w = 0;          ///< of unbalance, bow, weight and kick
  double damping_w = 0;          ///< of the structure, and of stiffness that is not symmetric
  double contact_damping_w = 0;  ///< of the contacts' dampers, <= 0
  double friction_w = 0;         ///< of friction on the coordinates: - friction times sliding speed
};

/// Energy of a structure without its contacts at displacements `q_m` and velocities, when the shaft has made
/// `turns` turns since t = 0. A scene with torsion has forces that go by the angle of the rotor: NaN.
Energy structure_energy(const scene::Scene& scene, const Eigen::VectorXd& q_m,
                        const Eigen::VectorXd& rate_m_per_s, double turns);

/// Energy in the spring of a contact: the integral over the penetration of the spring force of
/// contact::elastogap or, `smoothing_m` > 0, contact::smoothed_elastogap.
double spring_energy_j(double stiffness_n_per_m, double penetration_m, double smoothing_m);

}  // namespace rubsweep::trace
