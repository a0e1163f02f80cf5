#include "rubsweep/numerics/dense/lu.hpp"

#include <Eigen/LU>

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

}  // namespace rubsweep::numerics::dense
