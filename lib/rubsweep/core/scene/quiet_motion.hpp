#pragma once

#include <Eigen/Core>
#include <complex>

#include "rubsweep/core/scene/scene.hpp"

namespace rubsweep::scene {

/// Largest value of a motion with orders 1 and 2 of the speed, and the phase where it occurs.
struct TopOfMotion {
  double value = 0;
  double phase_rad = 0;  ///< 0 to 2 pi; the first one if several are equal
};

/// Largest value of Re(first e^{i phase} + second e^{2 i phase}). Infinite, at phase 0, where a number is not
/// finite.
TopOfMotion largest_value(std::complex<double> first, std::complex<double> second);

/// Largest length of the vector Re(first e^{i phase} + second e^{2 i phase}), whose components are real.
TopOfMotion largest_distance(const Eigen::Vector2cd& first, const Eigen::Vector2cd& second);

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

/// Phase factor that puts the largest excursion of a contact along the normal `wall` at t = 0; 1 for a motion
/// of one order without an excursion, or with one that is not finite.
std::complex<double> phase_to_smallest_gap(const QuietMotion& motion,
                                           const structure::LinearSystem& structure, const Contact& contact,
                                           const Eigen::Vector2d& wall);

}  // namespace rubsweep::scene
