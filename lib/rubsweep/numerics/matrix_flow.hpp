#pragma once

#include <Eigen/Core>
#include <vector>

namespace rubsweep::numerics {

/// Generator of (u, u')' for u'' = -stiffness u - damping u', 2n x 2n.
Eigen::MatrixXd generator_of(const Eigen::MatrixXd& stiffness, const Eigen::MatrixXd& damping);

/// e^{generator duration}, to double rounding: computed in long double, as a step's error is repeated a
/// thousand times a turn.
Eigen::MatrixXd matrix_flow(const Eigen::MatrixXd& generator, double duration_s);

/// The same for the durations of a table of steps: `longest_s` times exact_step_size(k), k = 0, 1, ... Mostly
/// squares of each other, at a sixth of the cost.
std::vector<Eigen::MatrixXd> matrix_flows(const Eigen::MatrixXd& generator, double longest_s);

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
