#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "rubsweep/analysis/branch/curves/extended_system.hpp"

namespace rubsweep::branch::curves {

/// Monodromy matrices on both sides of a state.
struct MonodromyPair {
  Eigen::MatrixXd ahead, behind;
  double step = 0;  ///< distance from the state to either of them

  Eigen::MatrixXd slope() const { return (ahead - behind) / (2 * step); }
};

/// A monodromy matrix and how it changes.
struct MonodromyJet {
  Eigen::MatrixXd here;
  std::vector<Eigen::MatrixXd> by_parameter;  ///< derivative by each parameter
  /// A little along a unit vector of the state and against it; empty where the orbit cannot be followed
  /// there.
  std::function<std::optional<MonodromyPair>(const Eigen::VectorXd& direction)> along;
};

/// Bifurcation condition on the monodromy matrix of an orbit.
struct Condition {
  double value = 0;
  Eigen::RowVectorXd by_state, by_parameter;
  Critical critical;
};

/// `sign` (1 or -1) is a multiplier. `value` is the smallest singular value of M - sign with its left and
/// right vectors, a smooth function up to its sign. Empty where `along` is.
std::optional<Condition> singular_condition(const MonodromyJet& jet, double sign);

/// Condition of a torus: the pair of multipliers whose product is nearest to 1 has the product 1. Smooth
/// where the pair changes from complex to real. Empty where `along` is.
std::optional<Condition> pair_condition(const MonodromyJet& jet);

}  // namespace rubsweep::branch::curves
