#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "rubsweep/core/numerics/exponential_series.hpp"

namespace rubsweep::numerics {

/// Matrices in long double, for results that are small differences of large numbers.
using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
using LongVector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;

/// Generator of (u, u')' for u'' = -stiffness u - damping u', 2n x 2n.
Eigen::MatrixXd generator_of(const Eigen::MatrixXd& stiffness, const Eigen::MatrixXd& damping);

/// Flow e^{generator duration}, exact to double rounding. It is computed in long double, because the error of
/// a step is repeated a thousand times per turn.
Eigen::MatrixXd matrix_flow(const Eigen::MatrixXd& generator, double duration_s);

/// Flow for step k of a table, of duration `longest_s` times exact_step_size(k), and for up to six other
/// steps of its group. Each other flow is the square of the flow of the next shorter step, and costs a sixth
/// of a separate computation. Groups are the same whichever step is requested. Calls put(i, flow) for each
/// step i of the group.
void make_matrix_flows(const Eigen::MatrixXd& generator, double longest_s, int k,
                       const std::function<void(int, const Eigen::MatrixXd&)>& put);

/// Bounds of |row e^{A t}| over 0 <= t <= a horizon, component by component. Between grid points |row e^{A
/// s}| <= |row| e^{|A| s}, so that the bounds hold without sampling errors.
class FlowBound {
 public:
  FlowBound(const Eigen::MatrixXd& generator, double horizon_s, double fastest_rad_per_s);

  Eigen::RowVectorXd of(const Eigen::RowVectorXd& row) const;

 private:
  int points_;
  Eigen::MatrixXd step_, between_;  ///< e^{A s} and e^{|A| s}, s being the distance of grid points
};

/// A real 2 x 2 matrix: an oscillator (0, 1; -stiffness, -damping), a pair of complex eigenvalues (s, w; -w,
/// s), two real eigenvalues on the diagonal, or the flow of one of these.
struct Pair {
  double uu = 0, uv = 0, vu = 0, vv = 0;
};

/// Flow e^{generator duration} in closed form, for all kinds of eigenvalues and regular where they coincide:
/// e^{m t} (C I + S (G - m I)) with m = trace / 2, q = det - m^2, C = cos(sqrt(q) t), S = sin(sqrt(q) t) /
/// sqrt(q); for q < 0 with the hyperbolic functions.
Pair pair_flow(const Pair& generator, double duration);

/// Taylor coefficients of the flows of pairs in x = fastest t. For the generator G of pair j:
/// e^{G t} = sum_k x^k (unit(j, k) 1 + generator(j, k) G).
struct PairSeries {
  Eigen::Array<double, Eigen::Dynamic, most_series_terms> unit, generator;
};

/// `fastest_rad_per_s`: rate that none of the pairs exceeds much, so that |x| <= longest_series suffices.
PairSeries pair_series(const std::vector<Pair>& generators, double fastest_rad_per_s);

}  // namespace rubsweep::numerics
