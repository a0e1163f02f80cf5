#include "rubsweep/fit/mode_set.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <complex>

#include "rubsweep/error.hpp"

namespace rubsweep::fit {

ModeSet modes_at(const scene::PreparedMachine& prepared, double speed_rad_per_s) {
  const auto& assembly = prepared.assembly;
  const Eigen::Index n = assembly.system.coordinates();
  Eigen::MatrixXd damping = assembly.system.damping, stiffness = assembly.system.stiffness;
  if (assembly.gyroscopic.size() > 0) damping += speed_rad_per_s * assembly.gyroscopic;
  if (assembly.circulatory.size() > 0) stiffness += speed_rad_per_s * assembly.circulatory;
  const Eigen::PartialPivLU<Eigen::MatrixXd> mass(assembly.system.mass);
  // Rates in units of a typical one, so that both halves of a state are of one size.
  const double typical = std::sqrt(mass.solve(stiffness).norm());
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  system.topRightCorner(n, n) = typical * Eigen::MatrixXd::Identity(n, n);
  system.bottomLeftCorner(n, n) = -mass.solve(stiffness) / typical;
  system.bottomRightCorner(n, n) = -mass.solve(damping);
  const Eigen::EigenSolver<Eigen::MatrixXd> solver(system);
  if (solver.info() != Eigen::Success) throw SolverError("modes: the eigenvalue iteration does not converge");
  ModeSet modes{solver.eigenvalues(), solver.eigenvectors(), {}, {}};
  modes.vectors.bottomRows(n) *= typical;
  const Eigen::PartialPivLU<Eigen::MatrixXcd> inverse(modes.vectors);
  modes.inverse = inverse.inverse();
  if (!modes.inverse.allFinite()) throw SolverError("modes: they do not span the motion");
  modes.force = modes.inverse.rightCols(n) * mass.inverse().cast<std::complex<double>>();
  return modes;
}

}  // namespace rubsweep::fit
