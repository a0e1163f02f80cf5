#include "rubsweep/core/numerics/dense/factors.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/QR>

namespace rubsweep::numerics::dense {

using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

VectorXd solve(const MatrixXd& a, const VectorXd& b) { return a.partialPivLu().solve(b); }
VectorXcd solve(const MatrixXcd& a, const VectorXcd& b) { return a.partialPivLu().solve(b); }
MatrixXcd solve(const MatrixXcd& a, const MatrixXcd& b) { return a.partialPivLu().solve(b); }
MatrixXcd inverse(const MatrixXcd& a) { return a.partialPivLu().inverse(); }

double determinant(const MatrixXd& a) { return a.partialPivLu().determinant(); }

VectorXd solve_full_pivot(const MatrixXd& a, const VectorXd& b) { return a.fullPivLu().solve(b); }
MatrixXd solve_full_pivot(const MatrixXd& a, const MatrixXd& b) { return a.fullPivLu().solve(b); }
VectorXcd solve_full_pivot(const MatrixXcd& a, const VectorXcd& b) { return a.fullPivLu().solve(b); }

LuFactors::LuFactors(const MatrixXd& a) : lu_(std::make_shared<const Eigen::PartialPivLU<MatrixXd>>(a)) {}
VectorXd LuFactors::solve(const VectorXd& b) const { return lu_->solve(b); }
MatrixXd LuFactors::solve(const MatrixXd& b) const { return lu_->solve(b); }
double LuFactors::reciprocal_condition() const { return lu_->rcond(); }

FullPivotFactors::FullPivotFactors(const MatrixXd& a)
    : lu_(std::make_shared<const Eigen::FullPivLU<MatrixXd>>(a)) {}
bool FullPivotFactors::invertible() const { return lu_->isInvertible(); }
double FullPivotFactors::reciprocal_condition() const { return lu_->rcond(); }
VectorXd FullPivotFactors::solve(const VectorXd& b) const { return lu_->solve(b); }
MatrixXd FullPivotFactors::solve(const MatrixXd& b) const { return lu_->solve(b); }
MatrixXd FullPivotFactors::inverse() const { return lu_->inverse(); }
MatrixXd FullPivotFactors::kernel() const { return lu_->kernel(); }

CholeskyFactors::CholeskyFactors(const MatrixXd& a) : llt_(std::make_shared<const Eigen::LLT<MatrixXd>>(a)) {}
bool CholeskyFactors::positive_definite() const { return llt_->info() == Eigen::Success; }
VectorXd CholeskyFactors::solve(const VectorXd& b) const { return llt_->solve(b); }
MatrixXd CholeskyFactors::solve(const MatrixXd& b) const { return llt_->solve(b); }
MatrixXd CholeskyFactors::solve_lower(const MatrixXd& b) const { return llt_->matrixL().solve(b); }
MatrixXd CholeskyFactors::solve_upper(const MatrixXd& b) const { return llt_->matrixU().solve(b); }
MatrixXd CholeskyFactors::upper() const { return llt_->matrixU(); }

SymmetricFactors::SymmetricFactors(const MatrixXd& a)
    : ldlt_(std::make_shared<const Eigen::LDLT<MatrixXd>>(a)) {}
VectorXd SymmetricFactors::solve(const VectorXd& b) const { return ldlt_->solve(b); }
MatrixXd SymmetricFactors::solve(const MatrixXd& b) const { return ldlt_->solve(b); }

VectorXd least_norm_solution(const MatrixXd& a, const VectorXd& b) {
  return a.completeOrthogonalDecomposition().solve(b);
}
MatrixXd least_norm_solution(const MatrixXd& a, const MatrixXd& b) {
  return a.completeOrthogonalDecomposition().solve(b);
}
VectorXcd least_norm_solution(const MatrixXcd& a, const VectorXcd& b) {
  const Eigen::Index rows = a.rows(), columns = a.cols();
  MatrixXd parts(2 * rows, 2 * columns);
  parts << a.real(), -a.imag(), a.imag(), a.real();
  VectorXd sides(2 * rows);
  sides << b.real(), b.imag();
  const VectorXd x = least_norm_solution(parts, sides);
  VectorXcd joined(columns);
  joined.real() = x.head(columns);
  joined.imag() = x.tail(columns);
  return joined;
}

MatrixXd orthonormal_columns(const MatrixXd& a, Eigen::Index count) {
  return a.householderQr().householderQ() * MatrixXd::Identity(a.rows(), count);
}

}  // namespace rubsweep::numerics::dense
