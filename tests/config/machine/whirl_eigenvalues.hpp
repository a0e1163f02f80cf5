#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <complex>
#include <vector>

#include "rubsweep/structure/beam_shaft.hpp"
#include "rubsweep/structure/lateral_system.hpp"

namespace rubsweep::config::machine {

/// The rotor in all its coordinates.
inline structure::LateralSystem full(const model::RotorKit& kit) {
  const structure::BeamShaft shaft = structure::assemble_beam_shaft(kit, {});
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(shaft.coordinates(), shaft.coordinates());
  return structure::project(shaft, {identity, identity});
}

/// Eigenvalues with a positive imaginary part, by it.
inline std::vector<std::complex<double>> eigenvalues(const model::RotorKit& kit, double speed_rad_per_s) {
  const structure::LateralSystem system = full(kit);
  const Eigen::Index n = system.coordinates();
  const Eigen::LLT<Eigen::MatrixXd> mass(system.mass);
  const auto normalised = [&](const Eigen::MatrixXd& matrix) {
    const Eigen::MatrixXd half = mass.matrixL().solve(matrix);
    return Eigen::MatrixXd(mass.matrixL().solve(Eigen::MatrixXd(half.transpose())).transpose());
  };
  // Displacements in units in which they are as large as velocities: otherwise slow modes lose their digits.
  const Eigen::MatrixXd stiffness = normalised(system.stiffness);
  const Eigen::VectorXd rate = stiffness.diagonal().cwiseSqrt();
  Eigen::MatrixXd generator = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  generator.topRightCorner(n, n) = rate.asDiagonal();
  generator.bottomLeftCorner(n, n) = -stiffness * rate.cwiseInverse().asDiagonal();
  generator.bottomRightCorner(n, n) = -normalised(system.damping + speed_rad_per_s * system.gyroscopic);
  std::vector<std::complex<double>> found;
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(generator, false);
  for (const auto& value : solver.eigenvalues()) {
    if (value.imag() > 0) found.push_back(value);
  }
  std::ranges::sort(found, {}, [](const std::complex<double>& value) { return value.imag(); });
  return found;
}

}  // namespace rubsweep::config::machine
