#include "rubsweep/core/numerics/dense/cholesky.hpp"

#include <Eigen/Cholesky>

namespace rubsweep::numerics::dense {

using Eigen::MatrixXd;
using Eigen::VectorXd;

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

}  // namespace rubsweep::numerics::dense
