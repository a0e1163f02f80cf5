#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "rubsweep/core/numerics/exponential_series.hpp"

namespace rubsweep::numerics {

/// Matrices whose results are small differences of large numbers.
using LongMatrix = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
using LongVector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;

/// Generator of (u, u')' for u'' = -stiffness u - damping u', 2n x 2n.
Eigen::MatrixXd generator_of(const Eigen::MatrixXd& stiffness, const Eigen::MatrixXd& damping);

/// e^{generator duration}, to double rounding: computed in long double, as a step's error is repeated a
/// thousand times a turn.
Eigen::MatrixXd matrix_flow(const Eigen::MatrixXd& generator, double duration_s);

/// The same for step k of a table, which lasts `longest_s` times exact_step_size(k), and for up to six
/// others: squares one of the other, which cost a sixth each. Every step belongs to one such group, whichever
/// of it is asked for. Calls put(i, flow) for each of its steps i.
void make_matrix_flows(const Eigen::MatrixXd& generator, double longest_s, int k,
                       const std::function<void(int, const Eigen::MatrixXd&)>& put);

/// Bounds of |row e^{A t}| over 0 <= t <= a horizon, component by component. Between the points of a grid
/// |row e^{A s}| <= |row| e^{|A| s}, so that nothing is left to sampling.
class FlowBound {
 public:
  FlowBound(const Eigen::MatrixXd& generator, double horizon_s, double fastest_rad_per_s);

  Eigen::RowVectorXd of(const Eigen::RowVectorXd& row) const;

 private:
  int points_;
  Eigen::MatrixXd step_, between_;  ///< e^{A s} and e^{|A| s} from one point to the next
};

/// A real 2 x 2 matrix: an oscillator (0, 1; -stiffness, -damping), a pair of complex eigenvalues (s, w; -w,
/// s), two real ones on the diagonal, or the flow of one of these.
struct Pair {
  double uu = 0, uv = 0, vu = 0, vv = 0;
};

/// e^{generator duration}, closed form for every kind of eigenvalues and regular where they meet:
/// e^{m t} (C I + S (G - m I)) with m = trace / 2, q = det - m^2, C = cos(sqrt(q) t), S = sin(sqrt(q) t) /
/// sqrt(q), or their hyperbolic partners for q < 0.
Pair pair_flow(const Pair& generator, double duration);

/// Taylor coefficients of the flows of pairs, x = fastest t: with the generator G of pair j
/// e^{G t} = sum_k x^k (unit(j, k) 1 + generator(j, k) G).
struct PairSeries {
  Eigen::Array<double, Eigen::Dynamic, most_series_terms> unit, generator;
};

/// `fastest_rad_per_s`: a unit of time in which no pair is fast, so that |x| <= longest_series suffices.
PairSeries pair_series(const std::vector<Pair>& generators, double fastest_rad_per_s);

}  // namespace rubsweep::numerics
