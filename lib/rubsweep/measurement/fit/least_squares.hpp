#pragma once

#include <Eigen/Core>
#include <atomic>
#include <functional>
#include <string>
#include <vector>

namespace rubsweep::fit {

/// A number that is looked for.
struct Parameter {
  std::string name;
  double start = 0;
  double low = 0, high = 0;  ///< low < high; start lies between
  /// Size of a change that matters: steps of the derivatives are a hundred-thousandth of it.
  double scale = 1;
};

struct LeastSquares {
  std::vector<Parameter> parameters;
  /// Residuals at values of the parameters, always as many. May throw ConfigError or SolverError: these
  /// values are then impossible. May be called by several threads at once.
  std::function<Eigen::VectorXd(const Eigen::VectorXd&)> residuals;
  /// Told of the values that a start begins at and of those that each step leads to, never beside
  /// `residuals`.
  std::function<void(const Eigen::VectorXd&)> accepted{};
};

struct LeastSquaresOptions {
  /// Residuals beyond this many root mean squares of the first fit count by their size and not its square
  /// (Huber); 0: all count by the square.
  double robust_beyond = 0;
  int starts = 1;            ///< further ones are drawn between the bounds, the same in every run
  int most_iterations = 60;  ///< limit of each start
  std::function<void(int start, int iteration, double cost)> on_iteration{};
  /// The best so far is returned, without waiting for the derivatives that are being made; no value where
  /// there is none yet.
  const std::atomic<bool>* stop = nullptr;
};

/// Minimum of the sum of squares / 2, and what the data say of it near there.
struct LeastSquaresFit {
  Eigen::VectorXd value, residuals;
  double cost = 0;
  Eigen::MatrixXd jacobian;      ///< derivatives of the residuals, by central differences
  int iterations = 0;            ///< iterations of the best start
  int starts = 0, agreeing = 0;  ///< finished ones, and those that reached the same cost within 1 %
  bool converged = false, stopped = false;
  std::vector<bool> at_bound;  ///< flag of each parameter
};

/// Levenberg and Marquardt's descent between bounds (Ceres Solver), from each start; derivatives by central
/// differences, on two threads. Throws SolverError where the residuals cannot be had at the first start.
LeastSquaresFit least_squares(const LeastSquares& problem, const LeastSquaresOptions& options = {});

}  // namespace rubsweep::fit
