#include "rubsweep/ring/normal_form.hpp"

#include <cmath>

#include "rubsweep/core/error.hpp"
#include "rubsweep/core/numerics/dense/lu.hpp"

namespace rubsweep::ring {

using Eigen::MatrixXd;

NormalForm normal_form(const System& system) {
  const Matrices matrices = assemble(system);
  const Eigen::ArrayXd diagonal = matrices.mass.diagonal().array().abs();
  if (!(diagonal > 0).all()) throw ConfigError("the mass matrix is singular: a load that moves needs a mass");
  const Eigen::VectorXd scale = diagonal.rsqrt();
  const auto scaled = [&](const MatrixXd& matrix) -> MatrixXd {
    return scale.asDiagonal() * matrix * scale.asDiagonal();
  };
  const numerics::dense::LuFactors mass(scaled(matrices.mass));
  if (!(mass.reciprocal_condition() > 1e-12)) {
    throw ConfigError("the mass matrix is singular: friction cancels the inertia of a load");
  }
  const MatrixXd stiffness = mass.solve(scaled(matrices.stiffness));
  NormalForm form;
  form.reference_rad_per_s = std::sqrt(stiffness.diagonal().cwiseAbs().maxCoeff());
  form.has_friction = system.friction_coefficient != 0;
  form.stiffness = stiffness / (form.reference_rad_per_s * form.reference_rad_per_s);
  form.rotation = mass.solve(scaled(matrices.rotation));
  form.softening = mass.solve(scaled(matrices.softening));
  return form;
}

MatrixXd state_matrix(const NormalForm& form, double speed_rad_per_s) {
  const double speed = speed_rad_per_s / form.reference_rad_per_s;
  const Eigen::Index size = form.coordinates();
  MatrixXd state(2 * size, 2 * size);
  state.topLeftCorner(size, size).setZero();
  state.topRightCorner(size, size).setIdentity();
  state.bottomLeftCorner(size, size) = speed * speed * form.softening - form.stiffness;
  state.bottomRightCorner(size, size) = -speed * form.rotation;
  return state;
}

MatrixXd state_matrix_slope(const NormalForm& form, double speed_rad_per_s) {
  const double speed = speed_rad_per_s / form.reference_rad_per_s;
  const Eigen::Index size = form.coordinates();
  MatrixXd slope = MatrixXd::Zero(2 * size, 2 * size);
  slope.bottomLeftCorner(size, size) = 2 * speed * form.softening;
  slope.bottomRightCorner(size, size) = -form.rotation;
  return slope;
}

}  // namespace rubsweep::ring
