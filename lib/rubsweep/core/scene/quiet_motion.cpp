#include "rubsweep/core/scene/quiet_motion.hpp"

#include <complex>

#include "rubsweep/core/numerics/dense/factors.hpp"
#include "rubsweep/core/scene/two_orders.hpp"

namespace rubsweep::scene {

Eigen::VectorXd QuietMotion::displacement(double phase_rad) const {
  Eigen::VectorXd displacement = mean + (amplitude * std::polar(1.0, phase_rad)).real();
  if (second_amplitude.size() > 0) displacement += (second_amplitude * std::polar(1.0, 2 * phase_rad)).real();
  return displacement;
}

Eigen::VectorXd QuietMotion::velocity(double phase_rad) const {
  const std::complex<double> i(0, 1);
  Eigen::VectorXd velocity = (amplitude * (i * std::polar(1.0, phase_rad))).real();
  if (second_amplitude.size() > 0)
    velocity += (second_amplitude * (2.0 * i * std::polar(1.0, 2 * phase_rad))).real();
  return velocity;
}

namespace {

/// An undamped part at its own frequency makes the matrix singular, which matters only if a force excites
/// that part. Without excitation it stays at rest (the solution of least norm).
Eigen::VectorXcd amplitude_of(const Eigen::MatrixXcd& dynamic_stiffness, const Eigen::VectorXcd& harmonic_n) {
  Eigen::VectorXcd amplitude = numerics::dense::solve(dynamic_stiffness, harmonic_n);
  if (amplitude.allFinite()) return amplitude;
  const Eigen::VectorXcd least = numerics::dense::least_norm_solution(dynamic_stiffness, harmonic_n);
  const double defect = (dynamic_stiffness * least - harmonic_n).norm();
  return defect <= 1e-12 * harmonic_n.norm() ? least : amplitude;
}

Eigen::MatrixXcd dynamic_stiffness(const structure::LinearSystem& structure, double w) {
  Eigen::MatrixXcd dynamic = (structure.stiffness - w * w * structure.mass).cast<std::complex<double>>();
  dynamic += std::complex<double>(0, w) * structure.damping.cast<std::complex<double>>();
  return dynamic;
}

/// Largest rise above its mean of a motion along the wall's normal, or in any direction in an annular stop.
double reach_of(const QuietMotion& motion, const contact::Wall& wall, const contact::RelativeMap& relative) {
  const Eigen::MatrixXcd seen = contact::linear(wall)
                                    ? Eigen::MatrixXcd(contact::first_direction(wall).transpose() * relative)
                                    : Eigen::MatrixXcd(relative);
  const Eigen::VectorXcd first = seen * motion.amplitude, second = seen * motion.second_amplitude;
  return contact::linear(wall) ? largest_value(first(0), second(0)).value
                               : largest_distance(first, second).value;
}

}  // namespace

QuietMotion quiet_motion(const structure::LinearSystem& structure, double speed_rad_per_s,
                         const Eigen::VectorXcd& harmonic_n, const Eigen::VectorXd& constant_n,
                         const Eigen::VectorXcd& second_harmonic_n) {
  QuietMotion motion;
  motion.amplitude = amplitude_of(dynamic_stiffness(structure, speed_rad_per_s), harmonic_n);
  if (second_harmonic_n.size() > 0) {
    motion.second_amplitude =
        amplitude_of(dynamic_stiffness(structure, 2 * speed_rad_per_s), second_harmonic_n);
  }
  motion.mean = constant_n.isZero(0) ? Eigen::VectorXd(Eigen::VectorXd::Zero(constant_n.size()))
                                     : numerics::dense::solve(structure.stiffness, constant_n);
  return motion;
}

contact::RelativeMap relative_map(const structure::LinearSystem& structure, const Contact& contact) {
  contact::RelativeMap map = structure.points[static_cast<std::size_t>(contact.rotor_point)].map;
  if (contact.casing_point) map -= structure.points[static_cast<std::size_t>(*contact.casing_point)].map;
  return map;
}

contact::Excursion quiet_penetration(const QuietMotion& motion, const structure::LinearSystem& structure,
                                     const Contact& contact) {
  const contact::RelativeMap relative = relative_map(structure, contact);
  contact::Excursion excursion =
      contact::excursion(contact.wall, contact.clearance_m, relative, motion.mean, motion.amplitude);
  if (motion.second_amplitude.size() > 0) excursion.amplitude = reach_of(motion, contact.wall, relative);
  return excursion;
}

Eigen::Vector2d nearest_wall(const QuietMotion& motion, const structure::LinearSystem& structure,
                             const Contact& contact) {
  const Eigen::Vector2d mean_m =
      relative_map(structure, contact) * motion.mean + contact::offset(contact.wall);
  return contact::normal_at(contact.wall, mean_m);
}

}  // namespace rubsweep::scene
