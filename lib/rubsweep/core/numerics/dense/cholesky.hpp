#pragma once

#include <Eigen/Core>
#include <memory>

namespace rubsweep::numerics::dense {

/// Factors of a symmetric positive definite matrix a = lower lower^T whose size is known at run time (LLT).
/// Here so that Eigen's templates are compiled once.
class CholeskyFactors {
 public:
  CholeskyFactors() = default;  ///< of no matrix; another one must be assigned before it is used
  explicit CholeskyFactors(const Eigen::MatrixXd& a);
  bool positive_definite() const;  ///< else nothing below means anything
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
  Eigen::MatrixXd solve(const Eigen::MatrixXd& b) const;
  Eigen::MatrixXd solve_lower(const Eigen::MatrixXd& b) const;  ///< lower^-1 b
  Eigen::MatrixXd solve_upper(const Eigen::MatrixXd& b) const;  ///< lower^-T b
  Eigen::MatrixXd upper() const;                                ///< lower^T

 private:
  std::shared_ptr<const Eigen::LLT<Eigen::MatrixXd>> llt_;
};

/// Factors of a symmetric matrix a = P^T lower diagonal lower^T P (LDLT), kept for several right-hand sides.
class SymmetricFactors {
 public:
  explicit SymmetricFactors(const Eigen::MatrixXd& a);
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
  Eigen::MatrixXd solve(const Eigen::MatrixXd& b) const;

 private:
  std::shared_ptr<const Eigen::LDLT<Eigen::MatrixXd>> ldlt_;
};

}  // namespace rubsweep::numerics::dense
