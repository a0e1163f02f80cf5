#pragma once

#include <Eigen/Core>

#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::scene {

/// Steady motion of a structure without contact: q(t) = mean + Re(amplitude e^{i w t} + second_amplitude e^{2
/// i w t}).
struct QuietMotion {
  Eigen::VectorXd mean;
  Eigen::VectorXcd amplitude;
  Eigen::VectorXcd second_amplitude{};  ///< empty: none

  Eigen::VectorXd displacement(double phase_rad) const;
  /// Velocity per radian of phase; multiply by the speed in rad/s for m/s.
  Eigen::VectorXd velocity(double phase_rad) const;
};

/// Closed form: K mean = constant, (K - w^2 M + i w C) amplitude = harmonic, and the same at 2 w for a second
/// harmonic, if there is one. Not finite at an undamped resonance or where the stiffness is singular.
QuietMotion quiet_motion(const structure::LinearSystem& structure, double speed_rad_per_s,
                         const Eigen::VectorXcd& harmonic_n, const Eigen::VectorXd& constant_n,
                         const Eigen::VectorXcd& second_harmonic_n = {});

/// Penetration of one contact under a quiet motion, in metres, as by contact::excursion.
contact::Excursion quiet_penetration(const QuietMotion& motion, const structure::LinearSystem& structure,
                                     const Contact& contact);

/// Direction from the rotor's mean position to the nearest place of the wall: the normal of a flat wall, or
/// the direction of the mean offset in an annular stop (+y if centred).
Eigen::Vector2d nearest_wall(const QuietMotion& motion, const structure::LinearSystem& structure,
                             const Contact& contact);

/// Rows that map q to the displacement of the rotor relative to the casing, 2 x n.
contact::RelativeMap relative_map(const structure::LinearSystem& structure, const Contact& contact);

}  // namespace rubsweep::scene
