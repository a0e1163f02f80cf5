#pragma once

#include <Eigen/Core>
#include <memory>

namespace rubsweep::numerics::dense {

/// LU decompositions of matrices whose size is known at run time. Here so that Eigen's templates are compiled
/// once: a source that uses one needs seconds for them.

/// a^-1 b by partialPivLu; not finite where `a` is singular.
Eigen::VectorXd solve(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);
Eigen::VectorXcd solve(const Eigen::MatrixXcd& a, const Eigen::VectorXcd& b);
Eigen::MatrixXcd solve(const Eigen::MatrixXcd& a, const Eigen::MatrixXcd& b);
/// a^-1 by partialPivLu.
Eigen::MatrixXcd inverse(const Eigen::MatrixXcd& a);
/// Determinant by partialPivLu.
double determinant(const Eigen::MatrixXd& a);

/// a^-1 b by fullPivLu, for matrices that may be close to singular.
Eigen::VectorXd solve_full_pivot(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);
Eigen::MatrixXd solve_full_pivot(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);
Eigen::VectorXcd solve_full_pivot(const Eigen::MatrixXcd& a, const Eigen::VectorXcd& b);

/// Factors of a square matrix (PartialPivLU), kept for several right-hand sides.
class LuFactors {
 public:
  explicit LuFactors(const Eigen::MatrixXd& a);
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
  Eigen::MatrixXd solve(const Eigen::MatrixXd& b) const;
  double reciprocal_condition() const;  ///< estimated, in the 1-norm

 private:
  std::shared_ptr<const Eigen::PartialPivLU<Eigen::MatrixXd>> lu_;
};

/// Factors of a matrix with pivots from all rows and columns (FullPivLU), which tell its rank.
class FullPivotFactors {
 public:
  explicit FullPivotFactors(const Eigen::MatrixXd& a);
  bool invertible() const;              ///< square and of full rank
  double reciprocal_condition() const;  ///< estimated, in the 1-norm
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
  Eigen::MatrixXd solve(const Eigen::MatrixXd& b) const;
  Eigen::MatrixXd inverse() const;
  Eigen::MatrixXd kernel() const;  ///< basis, one vector a column; a zero column where only zero is in it

 private:
  std::shared_ptr<const Eigen::FullPivLU<Eigen::MatrixXd>> lu_;
};

/// Factors of a symmetric positive definite matrix a = lower lower^T whose size is known at run time (LLT).
/// Here so that Eigen's templates are compiled once.
class CholeskyFactors {
 public:
  CholeskyFactors() = default;  ///< factors of no matrix; another one must be assigned before it is used
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

/// The x of least norm among those of least |a x - b|, by completeOrthogonalDecomposition, of matrices whose
/// size is known at run time. Here so that Eigen's templates are compiled once.
Eigen::VectorXd least_norm_solution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);
Eigen::MatrixXd least_norm_solution(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);
/// The same by real and imaginary parts, whose least squares and norm are equal.
Eigen::VectorXcd least_norm_solution(const Eigen::MatrixXcd& a, const Eigen::VectorXcd& b);

/// First `count` columns of the orthogonal factor of householderQr, of a matrix whose size is known at run
/// time. Here so that Eigen's templates are compiled once.
Eigen::MatrixXd orthonormal_columns(const Eigen::MatrixXd& a, Eigen::Index count);

}  // namespace rubsweep::numerics::dense
