#include "rubsweep/core/numerics/modal_form.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace rubsweep::numerics {
namespace {

constexpr double largest_condition = 1e4;

/// Modal form of diagonal matrices, from rounded numbers, so that the pairs agree with the generator.
ModalForm diagonal_form(const Eigen::MatrixXd& stiffness, const Eigen::MatrixXd& damping) {
  const Eigen::Index n = stiffness.rows();
  ModalForm form{Eigen::MatrixXd::Identity(2 * n, 2 * n), Eigen::MatrixXd::Identity(2 * n, 2 * n), {}, 0};
  form.unrounded_basis = form.unrounded_inverse = LongMatrix::Identity(2 * n, 2 * n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const double root = std::sqrt(stiffness(j, j));
    form.basis(n + j, n + j) = root;
    form.inverse(n + j, n + j) = 1 / root;
    form.unrounded_basis(n + j, n + j) = root;
    form.unrounded_inverse(n + j, n + j) = 1 / static_cast<long double>(root);
    form.pairs.push_back({0, root, -root, -damping(j, j)});
    form.growth = std::max(form.growth, -damping(j, j));
  }
  return form;
}

/// Sets the two columns of the basis and the generator of pair j.
void set_pair(ModalForm& form, LongMatrix& basis, Eigen::Index j, const LongVector& first,
              const LongVector& second, const Pair& generator) {
  const Eigen::Index n = basis.rows() / 2;
  // Displacements are scaled to order one, so that the length of a pair is in clearances.
  const long double size = std::sqrt(first.head(n).squaredNorm() + second.head(n).squaredNorm());
  basis.col(j) = first / size;
  basis.col(n + j) = second / size;
  form.pairs.push_back(generator);
}

}  // namespace

std::optional<ModalForm> modal_form(const Eigen::MatrixXd& stiffness, const Eigen::MatrixXd& damping) {
  return modal_form_of_unrounded(LongMatrix(stiffness.cast<long double>()),
                                 LongMatrix(damping.cast<long double>()));
}

std::optional<ModalForm> modal_form_of_unrounded(const LongMatrix& stiffness, const LongMatrix& damping) {
  const Eigen::Index n = stiffness.rows();
  const bool positive = stiffness.diagonal().minCoeff() > 0;
  if (stiffness.isDiagonal(0) && damping.isDiagonal(0) && positive)
    return diagonal_form(stiffness.cast<double>(), damping.cast<double>());

  // Time in units of the fastest frequency, so that displacements and velocities are of equal size.
  const long double unit = std::sqrt(stiffness.cwiseAbs().maxCoeff());
  LongMatrix a = LongMatrix::Zero(2 * n, 2 * n);
  a.topRightCorner(n, n).setIdentity();
  a.bottomLeftCorner(n, n) = -stiffness / (unit * unit);
  a.bottomRightCorner(n, n) = -damping / unit;
  const Eigen::EigenSolver<LongMatrix> solver(a);
  if (solver.info() != Eigen::Success) return std::nullopt;

  ModalForm form;
  LongMatrix basis(2 * n, 2 * n);
  const auto& values = solver.eigenvalues();
  const auto vectors = solver.eigenvectors();
  std::vector<Eigen::Index> real;
  const auto rate = [&](long double value) { return static_cast<double>(value * unit); };
  Eigen::Index j = 0;
  for (Eigen::Index i = 0; i < 2 * n; ++i) {
    form.growth = std::max(form.growth, rate(values(i).real()));
    if (values(i).imag() == 0) real.push_back(i);
    if (!(values(i).imag() > 0)) continue;
    const double s = rate(values(i).real()), w = rate(values(i).imag());
    set_pair(form, basis, j++, vectors.col(i).real(), vectors.col(i).imag(), {s, w, -w, s});
  }
  for (std::size_t i = 0; i + 1 < real.size(); i += 2) {
    set_pair(form, basis, j++, vectors.col(real[i]).real(), vectors.col(real[i + 1]).real(),
             {rate(values(real[i]).real()), 0, 0, rate(values(real[i + 1]).real())});
  }
  if (j != n) return std::nullopt;
  const LongMatrix inverse = basis.partialPivLu().inverse();
  const LongMatrix condition = basis.cwiseAbs() * inverse.cwiseAbs();
  if (!inverse.allFinite() || condition.rowwise().sum().maxCoeff() > largest_condition) return std::nullopt;
  LongVector to_si = LongVector::Ones(2 * n);
  to_si.tail(n).setConstant(unit);
  form.unrounded_basis = to_si.asDiagonal() * basis;
  form.unrounded_inverse = inverse * to_si.cwiseInverse().asDiagonal();
  form.basis = form.unrounded_basis.cast<double>();
  form.inverse = form.unrounded_inverse.cast<double>();
  return form;
}

Eigen::RowVectorXd rate_of_row(const ModalForm& form, const Eigen::RowVectorXd& row) {
  const Eigen::Index n = row.size() / 2;
  Eigen::RowVectorXd rate(2 * n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const Pair& g = form.pairs[static_cast<std::size_t>(j)];
    rate(j) = row(j) * g.uu + row(n + j) * g.vu;
    rate(n + j) = row(j) * g.uv + row(n + j) * g.vv;
  }
  return rate;
}

Eigen::RowVectorXd bound_of_row(const ModalForm& form, const Eigen::RowVectorXd& row, double horizon_s) {
  const Eigen::Index n = row.size() / 2;
  const double growth = std::exp(std::max(0.0, form.growth) * horizon_s);
  Eigen::RowVectorXd bound = Eigen::RowVectorXd::Zero(2 * n);
  for (Eigen::Index j = 0; j < n; ++j) bound(j) = growth * std::hypot(row(j), row(n + j));
  return bound;
}

}  // namespace rubsweep::numerics
