#pragma once

#include <Eigen/Core>
#include <array>
#include <complex>
#include <string>
#include <utility>
#include <vector>

#include "rubsweep/core/model/shaft_matrices.hpp"

namespace rubsweep::structure {

/// Degrees of freedom x, y, rx, ry of nodes at these positions, numbered from 1 on.
inline std::vector<model::DegreeOfFreedom> freedoms_at(const std::vector<double>& position_m) {
  std::vector<model::DegreeOfFreedom> all;
  for (std::size_t i = 0; i < position_m.size(); ++i) {
    for (const auto direction :
         {model::Direction::x, model::Direction::y, model::Direction::rx, model::Direction::ry})
      all.push_back({std::to_string(i + 1), direction, position_m[i], {}});
  }
  return all;
}

/// Zero matrices for these degrees of freedom.
inline model::ShaftMatrices empty_matrices(std::vector<model::DegreeOfFreedom> freedoms) {
  const auto n = static_cast<Eigen::Index>(freedoms.size());
  model::ShaftMatrices matrices;
  matrices.degrees_of_freedom = std::move(freedoms);
  matrices.mass = matrices.damping = matrices.gyroscopic = matrices.stiffness = Eigen::MatrixXd::Zero(n, n);
  matrices.unbalance_kg = Eigen::VectorXcd::Zero(n);
  return matrices;
}

/// A disc of 2 kg that moves only in x and y, and a bracket of 5 kg beside the shaft; all numbers are
/// different. The disc is cross-coupled by 3e3 and -4e3 N/m.
inline model::ShaftMatrices disc_and_bracket() {
  using model::Direction;
  model::ShaftMatrices matrices = empty_matrices({{"disc", Direction::x, 0.5, {}},
                                                  {"disc", Direction::y, 0.5, {}},
                                                  {"bracket", Direction::x, {}, {}},
                                                  {"bracket", Direction::y, {}, {}}});
  matrices.mass.diagonal() << 2, 2, 5, 5;
  matrices.stiffness << 1e5, 3e3, -2e4, 0, -4e3, 2e5, 0, -2e4, -2e4, 0, 5e4, 0, 0, -2e4, 0, 6e4;
  matrices.damping.diagonal() << 10, 20, 30, 40;
  matrices.unbalance_kg << 2, std::complex<double>(0, -2), 0, 0;
  return matrices;
}

/// One element of a solid round steel shaft by Friswell, Penny, Garvey, Lees, Dynamics of Rotating Machines
/// (2010), equations 5.41 to 5.48. Coordinates u, v, theta, psi at both ends. The formulas use Phi with
/// Cowper's shear coefficient.
struct BookElement {
  Eigen::Matrix<double, 8, 8> mass, gyroscopic, stiffness;
};

inline BookElement book_element(double length, double diameter) {
  constexpr double young = 211e9, shear = 81.2e9, density = 7810, pi = 3.14159265358979323846;
  const double area = pi * diameter * diameter / 4,
               moment = pi * diameter * diameter * diameter * diameter / 64;
  const double poisson = young / (2 * shear) - 1;
  const double kappa = 6 * (1 + poisson) / (7 + 6 * poisson);
  const double p = 12 * young * moment / (kappa * shear * area * length * length), l = length;
  // Matrices of one plane, with deflection and slope at both ends; a common factor follows.
  Eigen::Matrix4d k, m, r;
  k << 12, 6 * l, -12, 6 * l,                           //
      6 * l, (4 + p) * l * l, -6 * l, (2 - p) * l * l,  //
      -12, -6 * l, 12, -6 * l,                          //
      6 * l, (2 - p) * l * l, -6 * l, (4 + p) * l * l;
  const double m1 = 312 + 588 * p + 280 * p * p, m2 = (44 + 77 * p + 35 * p * p) * l,
               m3 = 108 + 252 * p + 140 * p * p, m4 = -(26 + 63 * p + 35 * p * p) * l,
               m5 = (8 + 14 * p + 7 * p * p) * l * l, m6 = -(6 + 14 * p + 7 * p * p) * l * l;
  m << m1, m2, m3, m4,   //
      m2, m5, -m4, m6,   //
      m3, -m4, m1, -m2,  //
      m4, m6, -m2, m5;
  const double m7 = 36, m8 = (3 - 15 * p) * l, m9 = (4 + 5 * p + 10 * p * p) * l * l,
               m10 = (-1 - 5 * p + 5 * p * p) * l * l;
  r << m7, m8, -m7, m8,   //
      m8, m9, -m8, m10,   //
      -m7, -m8, m7, -m8,  //
      m8, m10, -m8, m9;
  k *= young * moment / ((1 + p) * l * l * l);
  m *= density * area * l / (840 * (1 + p) * (1 + p));
  r *= density * moment / (30 * (1 + p) * (1 + p) * l);
  BookElement element;
  element.mass.setZero(), element.gyroscopic.setZero(), element.stiffness.setZero();
  // Indices of x and its slope psi, and of y and its slope -theta.
  constexpr std::array<int, 4> x{0, 3, 4, 7}, y{1, 2, 5, 6};
  constexpr std::array<double, 4> sign{1, -1, 1, -1};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < 4; ++j) {
      const auto a = static_cast<Eigen::Index>(i), b = static_cast<Eigen::Index>(j);
      element.mass(x[i], x[j]) = m(a, b) + r(a, b);
      element.mass(y[i], y[j]) = sign[i] * sign[j] * (m(a, b) + r(a, b));
      element.stiffness(x[i], x[j]) = k(a, b);
      element.stiffness(y[i], y[j]) = sign[i] * sign[j] * k(a, b);
      // The polar inertia is twice the diametral one: x is coupled to the rate in y by the speed, with
      // positive sign.
      element.gyroscopic(x[i], y[j]) = 2 * sign[j] * r(a, b);
      element.gyroscopic(y[i], x[j]) = -2 * sign[i] * r(a, b);
    }
  }
  return element;
}

/// Example 5.9.1 of the same book, assembled element by element: two discs on a shaft of 1.5 m length and 50
/// mm diameter in six elements, on two bearings of 1 MN/m.
inline model::ShaftMatrices book_rotor() {
  model::ShaftMatrices rotor = empty_matrices(freedoms_at({0, 0.25, 0.5, 0.75, 1, 1.25, 1.5}));
  const BookElement element = book_element(0.25, 0.05);
  for (Eigen::Index i = 0; i < 6; ++i) {
    rotor.mass.block<8, 8>(4 * i, 4 * i) += element.mass;
    rotor.gyroscopic.block<8, 8>(4 * i, 4 * i) += element.gyroscopic;
    rotor.stiffness.block<8, 8>(4 * i, 4 * i) += element.stiffness;
  }
  struct Disc {
    Eigen::Index node;
    double mass, polar, diametral;
  };
  for (const Disc& disc : {Disc{2, 32.58972765304033, 0.32956362089137037, 0.17808928257067666},
                           Disc{4, 51.52526111152619, 0.8050822048675967, 0.42358058405433824}}) {
    const Eigen::Index x = 4 * disc.node, y = x + 1, rx = x + 2, ry = x + 3;
    rotor.mass(x, x) += disc.mass, rotor.mass(y, y) += disc.mass;
    rotor.mass(rx, rx) += disc.diametral, rotor.mass(ry, ry) += disc.diametral;
    // Gyroscopic coupling of the rotations about x and y: I_p w turns one rate into a moment about the other
    // axis.
    rotor.gyroscopic(rx, ry) += disc.polar, rotor.gyroscopic(ry, rx) -= disc.polar;
    rotor.unbalance_kg(x) = disc.mass, rotor.unbalance_kg(y) = std::complex<double>(0, -disc.mass);
  }
  for (const Eigen::Index x : {0, 24}) rotor.stiffness(x, x) += 1e6, rotor.stiffness(x + 1, x + 1) += 1e6;
  return rotor;
}

}  // namespace rubsweep::structure
