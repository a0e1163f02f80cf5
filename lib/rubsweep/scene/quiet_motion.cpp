#include "rubsweep/scene/quiet_motion.hpp"

#include <Eigen/LU>
#include <complex>

namespace rubsweep::scene {

Eigen::VectorXd QuietMotion::displacement(double phase_rad) const {
  return mean + (amplitude * std::polar(1.0, phase_rad)).real();
}

Eigen::VectorXd QuietMotion::velocity(double phase_rad) const {
  return (amplitude * (std::complex<double>(0, 1) * std::polar(1.0, phase_rad))).real();
}

QuietMotion quiet_motion(const structure::LinearSystem& structure, double speed_rad_per_s,
                         const Eigen::VectorXcd& harmonic_n, const Eigen::VectorXd& constant_n) {
  const double w = speed_rad_per_s;
  Eigen::MatrixXcd dynamic_stiffness = (structure.stiffness - w * w * structure.mass).cast<std::complex<double>>();
  dynamic_stiffness += std::complex<double>(0, w) * structure.damping.cast<std::complex<double>>();
  QuietMotion motion;
  motion.amplitude = dynamic_stiffness.partialPivLu().solve(harmonic_n);
  motion.mean = constant_n.isZero(0) ? Eigen::VectorXd(Eigen::VectorXd::Zero(constant_n.size()))
                                     : Eigen::VectorXd(structure.stiffness.partialPivLu().solve(constant_n));
  return motion;
}

Eigen::Matrix<double, 2, Eigen::Dynamic> relative_map(const structure::LinearSystem& structure,
                                                      const Contact& contact) {
  Eigen::Matrix<double, 2, Eigen::Dynamic> map =
      structure.points[static_cast<std::size_t>(contact.rotor_point)].map;
  if (contact.casing_point) map -= structure.points[static_cast<std::size_t>(*contact.casing_point)].map;
  return map;
}

QuietPenetration quiet_penetration(const QuietMotion& motion, const structure::LinearSystem& structure,
                                   const Contact& contact) {
  const Eigen::RowVectorXd row = contact.normal.transpose() * relative_map(structure, contact);
  const std::complex<double> amplitude = row.cast<std::complex<double>>() * motion.amplitude;
  return {row.dot(motion.mean) - contact.clearance_m, std::abs(amplitude)};
}

}  // namespace rubsweep::scene
