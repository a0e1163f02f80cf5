#include "rubsweep/core/scene/quiet_motion.hpp"

#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <complex>
#include <limits>
#include <vector>

#include "rubsweep/core/numerics/dense/factors.hpp"
#include "rubsweep/core/numerics/full_turn.hpp"

namespace rubsweep::scene {
namespace {

/// Samples per revolution. The functions below have no order above 4, so at most four maxima. Maxima less
/// than two samples apart differ by at most 1e-5 of the motion, and each maximum of the samples is refined.
constexpr int samples = 256;

/// Value of a function of the phase with its first two derivatives.
struct Local {
  double value = 0, slope = 0, curvature = 0;
};

/// Refines the phase of a maximum by Newton's iteration. Values of the function alone give this phase to only
/// half the digits.
template <class Function>
double polished(const Function& at, double phase_rad) {
  for (int step = 0; step < 3; ++step) {
    const Local here = at(phase_rad);
    if (!(here.curvature < 0)) break;
    const double next = phase_rad - here.slope / here.curvature;
    if (std::abs(at(next).slope) >= std::abs(here.slope)) break;
    phase_rad = next;
  }
  return phase_rad;
}

/// Largest value of `at`, which has no order above 4.
template <class Function>
TopOfMotion top_of(const Function& at) {
  std::vector<double> values;
  for (int k = 0; k < samples; ++k) values.push_back(at(numerics::full_turn * k / samples).value);
  const auto sampled = [&](int k) { return values[static_cast<std::size_t>((k + samples) % samples)]; };
  TopOfMotion top{-std::numeric_limits<double>::infinity(), 0};
  for (int k = 0; k < samples; ++k) {
    if (sampled(k) < sampled(k - 1) || sampled(k) <= sampled(k + 1)) continue;
    const auto below = [&](double phase_rad) { return -at(phase_rad).value; };
    const double found = boost::math::tools::brent_find_minima(below, numerics::full_turn * (k - 1) / samples,
                                                               numerics::full_turn * (k + 1) / samples, 26)
                             .first;
    const double phase_rad = polished(at, found), value = at(phase_rad).value;
    if (value > top.value) top = {value, phase_rad < 0 ? phase_rad + numerics::full_turn : phase_rad};
  }
  return std::isfinite(top.value) ? top : TopOfMotion{values.front(), 0};
}

constexpr TopOfMotion unbounded{std::numeric_limits<double>::infinity(), 0};

}  // namespace

TopOfMotion largest_value(std::complex<double> first, std::complex<double> second) {
  if (!std::isfinite(std::norm(first) + std::norm(second))) return unbounded;
  return top_of([&](double phase_rad) -> Local {
    const std::complex<double> i(0, 1), one = first * std::polar(1.0, phase_rad),
                                        two = second * std::polar(1.0, 2 * phase_rad);
    return {(one + two).real(), (i * (one + 2.0 * two)).real(), -(one + 4.0 * two).real()};
  });
}

TopOfMotion largest_distance(const Eigen::Vector2cd& first, const Eigen::Vector2cd& second) {
  const double size = std::sqrt(first.squaredNorm() + second.squaredNorm());
  if (!std::isfinite(size)) return unbounded;
  if (size == 0) return {};
  TopOfMotion top = top_of([&](double phase_rad) -> Local {
    const std::complex<double> i(0, 1);
    const Eigen::Vector2cd one = first / size * std::polar(1.0, phase_rad),
                           two = second / size * std::polar(1.0, 2 * phase_rad);
    const Eigen::Vector2d place = (one + two).real(), rate = (i * (one + 2.0 * two)).real(),
                          bend = -(one + 4.0 * two).real();
    return {place.squaredNorm() / 2, place.dot(rate), rate.squaredNorm() + place.dot(bend)};
  });
  top.value = size * std::sqrt(2 * top.value);
  return top;
}

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

std::complex<double> phase_to_smallest_gap(const QuietMotion& motion,
                                           const structure::LinearSystem& structure, const Contact& contact,
                                           const Eigen::Vector2d& wall) {
  const Eigen::RowVectorXd row = wall.transpose() * relative_map(structure, contact);
  const std::complex<double> amplitude = row.cast<std::complex<double>>() * motion.amplitude;
  if (motion.second_amplitude.size() > 0) {
    const std::complex<double> second = row.cast<std::complex<double>>() * motion.second_amplitude;
    return std::polar(1.0, largest_value(amplitude, second).phase_rad);
  }
  const double modulus = std::abs(amplitude);
  return modulus > 0 && std::isfinite(modulus) ? std::conj(amplitude) / modulus : 1.0;
}

}  // namespace rubsweep::scene
