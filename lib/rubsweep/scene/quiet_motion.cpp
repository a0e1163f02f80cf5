#include "rubsweep/scene/quiet_motion.hpp"

#include <complex>

#include "rubsweep/numerics/lu.hpp"
#include "rubsweep/numerics/orthogonal.hpp"

namespace rubsweep::scene {

Eigen::VectorXd QuietMotion::displacement(double phase_rad) const {
  return mean + (amplitude * std::polar(1.0, phase_rad)).real();
}

Eigen::VectorXd QuietMotion::velocity(double phase_rad) const {
  return (amplitude * (std::complex<double>(0, 1) * std::polar(1.0, phase_rad))).real();
}

namespace {

/// An undamped part at its own frequency makes the matrix singular, which matters only where something drives
/// that part: else it rests (the solution of least norm).
Eigen::VectorXcd amplitude_of(const Eigen::MatrixXcd& dynamic_stiffness, const Eigen::VectorXcd& harmonic_n) {
  Eigen::VectorXcd amplitude = numerics::solve(dynamic_stiffness, harmonic_n);
  if (amplitude.allFinite()) return amplitude;
  const Eigen::VectorXcd least = numerics::least_norm_solution(dynamic_stiffness, harmonic_n);
  const double defect = (dynamic_stiffness * least - harmonic_n).norm();
  return defect <= 1e-12 * harmonic_n.norm() ? least : amplitude;
}

}  // namespace

QuietMotion quiet_motion(const structure::LinearSystem& structure, double speed_rad_per_s,
                         const Eigen::VectorXcd& harmonic_n, const Eigen::VectorXd& constant_n) {
  const double w = speed_rad_per_s;
  Eigen::MatrixXcd dynamic_stiffness =
      (structure.stiffness - w * w * structure.mass).cast<std::complex<double>>();
  dynamic_stiffness += std::complex<double>(0, w) * structure.damping.cast<std::complex<double>>();
  QuietMotion motion;
  motion.amplitude = amplitude_of(dynamic_stiffness, harmonic_n);
  motion.mean = constant_n.isZero(0) ? Eigen::VectorXd(Eigen::VectorXd::Zero(constant_n.size()))
                                     : numerics::solve(structure.stiffness, constant_n);
  return motion;
}

contact::RelativeMap relative_map(const structure::LinearSystem& structure, const Contact& contact) {
  contact::RelativeMap map = structure.points[static_cast<std::size_t>(contact.rotor_point)].map;
  if (contact.casing_point) map -= structure.points[static_cast<std::size_t>(*contact.casing_point)].map;
  return map;
}

contact::Excursion quiet_penetration(const QuietMotion& motion, const structure::LinearSystem& structure,
                                     const Contact& contact) {
  return contact::excursion(contact.wall, contact.clearance_m, relative_map(structure, contact), motion.mean,
                            motion.amplitude);
}

Eigen::Vector2d nearest_wall(const QuietMotion& motion, const structure::LinearSystem& structure,
                             const Contact& contact) {
  const Eigen::Vector2d mean_m =
      relative_map(structure, contact) * motion.mean + contact::offset(contact.wall);
  return contact::normal_at(contact.wall, mean_m);
}

}  // namespace rubsweep::scene
