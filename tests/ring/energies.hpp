#pragma once

#include <Eigen/Core>
#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss.hpp>
#include <cmath>
#include <functional>

#include "rubsweep/ring/system.hpp"

namespace rubsweep::ring {

/// Equations of motion for unconstrained coordinates z: x = mass z'' + rotation z' + stiffness z - force.
/// They are derived from the kinetic energy T(z', z) and the potential energy V(z), both quadratic, by
/// differences that are exact for quadratic functions.
struct Unconstrained {
  Eigen::MatrixXd mass, rotation, stiffness;
  Eigen::VectorXd force;
};

using Vector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;
using Kinetic = std::function<long double(const Vector& velocity, const Vector& place)>;
using Potential = std::function<long double(const Vector& place)>;

inline Unconstrained lagrange(Eigen::Index size, const Kinetic& kinetic, const Potential& potential) {
  const auto both = [&](const Vector& state) {
    return kinetic(state.head(size), state.tail(size)) - potential(state.tail(size));
  };
  const Vector zero = Vector::Zero(2 * size);
  const auto unit = [&](Eigen::Index i) -> Vector { return Vector::Unit(2 * size, i); };
  const auto second = [&](Eigen::Index i, Eigen::Index j) {
    return static_cast<double>((both(unit(i) + unit(j)) - both(unit(i) - unit(j)) - both(unit(j) - unit(i)) +
                                both(-unit(i) - unit(j))) /
                               4);
  };
  Unconstrained result{Eigen::MatrixXd(size, size), Eigen::MatrixXd(size, size), Eigen::MatrixXd(size, size),
                       Eigen::VectorXd(size)};
  for (Eigen::Index i = 0; i < size; ++i) {
    for (Eigen::Index j = 0; j < size; ++j) {
      result.mass(i, j) = second(i, j);
      result.rotation(i, j) = second(i, size + j) - second(size + i, j);
      result.stiffness(i, j) = -second(size + i, size + j);
    }
    result.force(i) = static_cast<double>((both(unit(size + i)) - both(-unit(size + i))) / 2);
  }
  return result;
}

struct RingSection {
  long double mass_per_length, bending_stiffness, radius, thickness;  ///< rho S, E I, R, h of the paper
};

/// The ring in mode n with coordinates (A, B): integrals of the paper's energy densities over the
/// circumference.
inline Unconstrained ring_energies(const RingSection& ring, int n, long double speed) {
  constexpr int points = 64;  // the rectangle rule is exact for these harmonics
  const long double pi = boost::math::constants::pi<long double>();
  const auto around = [=](auto&& density) {
    long double sum = 0;
    for (int i = 0; i < points; ++i) sum += density(2 * pi * i / points);
    return sum * 2 * pi / points;
  };
  // Derivatives of the displacement w up to the fourth; u = w'.
  const auto w = [n](const Vector& z, long double angle, int derivative) {
    const long double phase = n * angle + derivative * boost::math::constants::half_pi<long double>();
    return std::pow(static_cast<long double>(n), derivative) *
           (z(0) * std::cos(phase) + z(1) * std::sin(phase));
  };
  const Kinetic kinetic = [=](const Vector& v, const Vector& z) {
    return around([&](long double angle) {
      const long double radial = w(v, angle, 1) - speed * w(z, angle, 2);
      const long double tangential = w(v, angle, 0) - speed * w(z, angle, 1);
      return ring.mass_per_length * ring.radius * (radial * radial + tangential * tangential) / 2;
    });
  };
  const Potential potential = [=](const Vector& z) {
    return around([&](long double angle) {
      const long double curvature = w(z, angle, 3) + w(z, angle, 1);
      return ring.bending_stiffness / (ring.radius * ring.radius * ring.radius) * curvature * curvature / 2;
    });
  };
  return lagrange(2, kinetic, potential);
}

/// A beam as long as the radius with the tip displacements (u, v): integrals over its Ritz functions.
inline Unconstrained beam_energies(const BeamGeometry& beam, long double length, long double speed) {
  const long double rho_s = beam.density_kg_per_m3 * beam.section_area_m2,
                    e_s = beam.youngs_modulus_pa * beam.section_area_m2;
  const long double rho_i = beam.density_kg_per_m3 * beam.second_moment_m4,
                    e_i = beam.youngs_modulus_pa * beam.second_moment_m4;
  const long double k = boost::math::constants::half_pi<long double>() / length;
  const auto along = [=](auto&& density) {
    return boost::math::quadrature::gauss<long double, 30>::integrate(density, 0.0L, length);
  };
  const Kinetic kinetic = [=](const Vector& rate, const Vector& z) {
    return along([&](long double x) {
      const long double s = std::sin(k * x), c = std::cos(k * x);
      const long double u = z(0) * s, du = rate(0) * s, v = z(1) * (1 - c), dv = rate(1) * (1 - c);
      const long double turn = speed + rate(1) * k * s;
      return rho_s / 2 *
                 (du * du + dv * dv + speed * speed * ((x + u) * (x + u) + v * v) +
                  2 * speed * (dv * (x + u) - du * v)) +
             rho_i / 2 * turn * turn;
    });
  };
  const Potential potential = [=](const Vector& z) {
    return along([&](long double x) {
      const long double stretch = z(0) * k * std::cos(k * x), bend = z(1) * k * k * std::cos(k * x);
      return (e_s * stretch * stretch + e_i * bend * bend) / 2;
    });
  };
  return lagrange(2, kinetic, potential);
}

/// A spring-mass with the coordinates (u, v) = (-u_s, x) of the paper's Appendix B.
inline Unconstrained spring_mass_energies(long double mass, long double radial, long double tangential,
                                          long double radius, long double speed) {
  const Kinetic kinetic = [=](const Vector& rate, const Vector& z) {
    const long double us = -z(0), dus = -rate(0), x = z(1), dx = rate(1);
    return mass / 2 * (dus * dus + speed * speed * (radius - us) * (radius - us)) +
           mass / 2 * (dx * dx + speed * speed * x * x) + mass * speed * (dus * x + dx * (radius - us));
  };
  const Potential potential = [=](const Vector& z) {
    return (radial * z(0) * z(0) + tangential * z(1) * z(1)) / 2;
  };
  return lagrange(2, kinetic, potential);
}

}  // namespace rubsweep::ring
