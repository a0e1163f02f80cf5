#pragma once

#include <Eigen/Core>
#include <atomic>
#include <functional>
#include <string>
#include <vector>

namespace rubsweep::fit {

/// A parameter to be fitted.
struct Parameter {
  std::string name;
  double start = 0;
  double low = 0, high = 0;  ///< low < high; `start` lies between them
  /// Typical size of a change; the step of the derivatives is 1e-5 of it.
  double scale = 1;
};

struct LeastSquares {
  std::vector<Parameter> parameters;
  /// Residuals at these parameter values; their number never changes. The function may throw ConfigError or
  /// SolverError: the values then count as impossible. Several threads may call it at once.
  std::function<Eigen::VectorXd(const Eigen::VectorXd&)> residuals;
  /// Called with the values at the start and after each step of a descent, never at the same time as
  /// `residuals`.
  std::function<void(const Eigen::VectorXd&)> accepted{};
};

struct LeastSquaresOptions {
  /// Residuals larger than this many root mean squares of the first fit enter the sum linearly instead of by
  /// their squares (Huber). 0: all enter by their squares.
  double robust_beyond = 0;
  /// number of starts; all but the first are drawn between the bounds, the same in every run
  int starts = 1;
  int most_iterations = 60;  ///< limit for each start
  std::function<void(int start, int iteration, double cost)> on_iteration{};
  /// When true, the best result so far is returned without waiting for unfinished derivatives. The result has
  /// no values if there is none yet.
  const std::atomic<bool>* stop = nullptr;
};

/// Minimum of half the sum of squares, with the derivatives there.
struct LeastSquaresFit {
  Eigen::VectorXd value, residuals;
  double cost = 0;
  Eigen::MatrixXd jacobian;      ///< derivatives of the residuals, by central differences
  int iterations = 0;            ///< iterations of the best start
  int starts = 0, agreeing = 0;  ///< finished starts, and those that reached the same cost within 1 %
  bool converged = false, stopped = false;
  std::vector<bool> at_bound;  ///< one flag per parameter
};

/// Levenberg-Marquardt descent between bounds (Ceres Solver) from each start, with derivatives by central
/// differences on two threads. Throws SolverError where the residuals do not exist at the first start.
LeastSquaresFit least_squares(const LeastSquares& problem, const LeastSquaresOptions& options = {});

}  // namespace rubsweep::fit
