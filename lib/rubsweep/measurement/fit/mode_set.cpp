#include "rubsweep/measurement/fit/mode_set.hpp"

#include <cmath>
#include <complex>
#include <utility>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/numerics/dense/eigenvalues.hpp"
#include "rubsweep/core/structure/system_at.hpp"

namespace rubsweep::fit {

ModeSet modes_at(const scene::PreparedMachine& prepared, double speed_rad_per_s) {
  const structure::LinearSystem system = structure::system_at(prepared.assembly, speed_rad_per_s);
  const Eigen::Index n = system.coordinates();
  const Eigen::PartialPivLU<Eigen::MatrixXd> mass(system.mass);
  // Rates in units of a typical one, so that both halves of a state are of one size.
  const double typical = std::sqrt(mass.solve(system.stiffness).norm());
  Eigen::MatrixXd generator = Eigen::MatrixXd::Zero(2 * n, 2 * n);
  generator.topRightCorner(n, n) = typical * Eigen::MatrixXd::Identity(n, n);
  generator.bottomLeftCorner(n, n) = -mass.solve(system.stiffness) / typical;
  generator.bottomRightCorner(n, n) = -mass.solve(system.damping);
  numerics::dense::GeneralModes found = numerics::dense::general_modes(generator, true);
  if (!found.converged) throw SolverError("modes: the eigenvalue iteration does not converge");
  ModeSet modes{std::move(found.values), std::move(found.vectors), {}, mass.inverse()};
  modes.vectors.bottomRows(n) *= typical;
  modes.factor.compute(modes.vectors);
  if (!modes.factor.matrixLU().allFinite() || !(modes.factor.matrixLU().diagonal().cwiseAbs().minCoeff() > 0))
    throw SolverError("modes: they do not span the motion");
  return modes;
}

Eigen::VectorXcd ModeSet::force(const Eigen::VectorXcd& newtons) const {
  Eigen::VectorXcd rate = Eigen::VectorXcd::Zero(values.size());
  rate.tail(newtons.size()) = inverse_mass.cast<std::complex<double>>() * newtons;
  return factor.solve(rate);
}

}  // namespace rubsweep::fit
