#pragma once

#include <Eigen/Core>
#include <memory>

namespace rubsweep::numerics::dense {

/// LU decompositions of matrices whose size is known at run time. Compiled here once, because Eigen's
/// templates take seconds in every source that uses them.

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
  double reciprocal_condition() const;  ///< estimate in the 1-norm

 private:
  std::shared_ptr<const Eigen::PartialPivLU<Eigen::MatrixXd>> lu_;
};

/// Factors of a matrix with full pivoting (FullPivLU), which reveal its rank.
class FullPivotFactors {
 public:
  explicit FullPivotFactors(const Eigen::MatrixXd& a);
  bool invertible() const;              ///< square and of full rank
  double reciprocal_condition() const;  ///< estimate in the 1-norm
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
  Eigen::MatrixXd solve(const Eigen::MatrixXd& b) const;
  Eigen::MatrixXd inverse() const;
  Eigen::MatrixXd kernel() const;  ///< basis of the null space as columns; one zero column if it is trivial

 private:
  std::shared_ptr<const Eigen::FullPivLU<Eigen::MatrixXd>> lu_;
};

/// Factors of a symmetric positive definite matrix a = lower lower^T whose size is known at run time (LLT).
/// Compiled here once.
class CholeskyFactors {
 public:
  CholeskyFactors() = default;  ///< no matrix; assign one before use
  explicit CholeskyFactors(const Eigen::MatrixXd& a);
  bool positive_definite() const;  ///< false: the results below are meaningless
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

/// The x of least norm among all minima of |a x - b|, by completeOrthogonalDecomposition, for matrices whose
/// size is known at run time. Compiled once, here.
Eigen::VectorXd least_norm_solution(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);
Eigen::MatrixXd least_norm_solution(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);
/// The complex problem, solved as a real one for real and imaginary parts, which has the same residual and
/// norm.
Eigen::VectorXcd least_norm_solution(const Eigen::MatrixXcd& a, const Eigen::VectorXcd& b);

/// First `count` columns of the orthogonal factor of householderQr, for a matrix whose size is known at run
/// time. Compiled here once.
Eigen::MatrixXd orthonormal_columns(const Eigen::MatrixXd& a, Eigen::Index count);

}  // namespace rubsweep::numerics::dense
