#pragma once

#include <Eigen/Core>
#include <functional>

namespace rubsweep::numerics {

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

}  // namespace rubsweep::numerics
