#include "rubsweep/core/numerics/dense/eigenvalues.hpp"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>

namespace rubsweep::numerics::dense {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Smallest ratio, in powers of two, between a row and its column for which the matrix is balanced first. The
/// generator of u'' = -k u has the ratio k; without balancing its eigenvalues lose a factor sqrt(k) in
/// relative accuracy.
constexpr int badly_scaled = 40;

/// log2 of the ratio between the off-diagonal parts of row `i` and column `i`; 0 where one of them is zero.
int imbalance(const MatrixXd& matrix, Eigen::Index i) {
  const double diagonal = std::abs(matrix(i, i));
  const double row = matrix.row(i).cwiseAbs().sum() - diagonal,
               column = matrix.col(i).cwiseAbs().sum() - diagonal;
  return row > 0 && column > 0 ? std::ilogb(row) - std::ilogb(column) : 0;
}

/// Similar matrix whose rows and columns have about equal norms. It is scaled by powers of two, which add no
/// rounding (Parlett and Reinsch, Balancing a matrix for calculation of eigenvalues and eigenvectors, 1969).
MatrixXd balanced(MatrixXd matrix) {
  bool needed = false;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i)
    needed = needed || std::abs(imbalance(matrix, i)) >= badly_scaled;
  constexpr int most_sweeps = 100;  // each one at least halves the imbalance
  for (int sweep = 0; needed && sweep < most_sweeps; ++sweep) {
    needed = false;
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
      const int half = imbalance(matrix, i) / 2;
      if (half == 0) continue;
      needed = true;
      matrix.row(i) *= std::ldexp(1.0, -half);
      matrix.col(i) *= std::ldexp(1.0, half);
    }
  }
  return matrix;
}

constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

}  // namespace

Eigen::VectorXcd eigenvalues(const MatrixXd& matrix) {
  const Eigen::VectorXcd none = Eigen::VectorXcd::Constant(matrix.rows(), not_known);
  // The iteration may report convergence for a matrix that is not finite.
  if (!matrix.allFinite()) return none;
  const Eigen::EigenSolver<MatrixXd> solver(balanced(matrix), false);
  return solver.info() == Eigen::Success ? solver.eigenvalues() : none;
}

Eigenvectors eigenvectors(const MatrixXd& matrix) {
  const Eigen::EigenSolver<MatrixXd> solver(matrix);
  if (solver.info() == Eigen::Success && matrix.allFinite())
    return {solver.eigenvalues(), solver.eigenvectors()};
  return {Eigen::VectorXcd::Constant(matrix.rows(), not_known),
          Eigen::MatrixXcd::Constant(matrix.rows(), matrix.rows(), not_known)};
}

GeneralModes general_modes(const Eigen::MatrixXd& matrix, bool with_vectors,
                           Eigen::Index iterations_per_row) {
  // One solver per thread: it keeps its workspace from one matrix to the next.
  thread_local Eigen::EigenSolver<Eigen::MatrixXd> solver;
  solver.setMaxIterations(iterations_per_row * matrix.rows());
  solver.compute(matrix, with_vectors);
  GeneralModes modes;
  modes.converged = solver.info() == Eigen::Success;
  if (!modes.converged) return modes;
  modes.values = solver.eigenvalues();
  if (with_vectors) modes.vectors = solver.eigenvectors();
  return modes;
}

double spectral_radius(const MatrixXd& matrix) { return eigenvalues(matrix).cwiseAbs().maxCoeff(); }

SelfAdjointModes<MatrixXd> self_adjoint_modes(const MatrixXd& a) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(a);
  return {solver.eigenvalues(), solver.eigenvectors(), solver.info() == Eigen::Success};
}

VectorXd self_adjoint_eigenvalues(const MatrixXd& a) {
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver(a, Eigen::EigenvaluesOnly);
  if (solver.info() == Eigen::Success) return solver.eigenvalues();
  return VectorXd::Constant(a.rows(), std::numeric_limits<double>::quiet_NaN());
}

}  // namespace rubsweep::numerics::dense
