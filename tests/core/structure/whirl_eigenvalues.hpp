#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <complex>
#include <vector>

#include "rubsweep/core/numerics/dense/eigenvalues.hpp"
#include "rubsweep/core/numerics/dense/factors.hpp"
#include "rubsweep/core/structure/beam_shaft.hpp"
#include "rubsweep/core/structure/lateral_system.hpp"

namespace rubsweep::structure {

/// The rotor without reduction, in all its coordinates.
inline LateralSystem full(const model::RotorKit& kit) {
  const BeamShaft shaft = assemble_beam_shaft(kit, {});
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(shaft.coordinates(), shaft.coordinates());
  return project(shaft, {identity, identity});
}

/// Eigenvalues with positive imaginary part at a shaft speed: one of each conjugate pair.
inline std::vector<std::complex<double>> whirl_eigenvalues(const LateralSystem& system,
                                                           double speed_rad_per_s) {
  const Eigen::Index n = system.coordinates();
  const numerics::dense::CholeskyFactors mass(system.mass);
  const auto normalised = [&](const Eigen::MatrixXd& matrix) {
    const Eigen::MatrixXd half = mass.solve_lower(matrix);
    return Eigen::MatrixXd(mass.solve_lower(half.transpose()).transpose());
  };
  // Displacements are scaled to the size of velocities; otherwise slow modes would lose their digits.
  const Eigen::MatrixXd stiffness = normalised(system.stiffness);
  const Eigen::VectorXd rate = stiffness.diagonal().cwiseSqrt();
  Eigen::MatrixXd generator = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  generator.topRightCorner(n, n) = rate.asDiagonal();
  generator.bottomLeftCorner(n, n) = -stiffness * rate.cwiseInverse().asDiagonal();
  generator.bottomRightCorner(n, n) = -normalised(system.damping + speed_rad_per_s * system.gyroscopic);
  std::vector<std::complex<double>> found;
  for (const auto& value : numerics::dense::eigenvalues(generator)) {
    if (value.imag() > 0) found.push_back(value);
  }
  std::ranges::sort(found, {}, [](const std::complex<double>& value) { return value.imag(); });
  return found;
}

}  // namespace rubsweep::structure
