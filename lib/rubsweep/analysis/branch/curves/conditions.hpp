#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <vector>

#include "rubsweep/analysis/branch/curves/extended_system.hpp"

namespace rubsweep::branch::curves {

/// Monodromy matrices at a small distance on both sides of a state.
struct MonodromyPair {
  Eigen::MatrixXd ahead, behind;
  double step = 0;  ///< distance of the two matrices' states from the state

  Eigen::MatrixXd slope() const { return (ahead - behind) / (2 * step); }
};

/// Monodromy matrix and its derivatives.
struct MonodromyJet {
  Eigen::MatrixXd here;
  std::vector<Eigen::MatrixXd> by_parameter;  ///< derivative by each parameter
  /// Monodromy matrices at states displaced by a small step along and against a unit vector; empty where an
  /// orbit cannot be followed there.
  std::function<std::optional<MonodromyPair>(const Eigen::VectorXd& direction)> along;
};

/// Bifurcation condition on the monodromy matrix M of an orbit.
struct Condition {
  double value = 0;
  Eigen::RowVectorXd by_state, by_parameter;
  Critical critical;
};

/// Condition that `sign` (1 or -1) is a multiplier. `value` is the smallest singular value of M - sign, with
/// its left and right singular vectors; apart from its sign it is a smooth function. Empty where `along`
/// returns nothing.
std::optional<Condition> singular_condition(const MonodromyJet& jet, double sign);

/// Condition of a torus: the two multipliers whose product is nearest to 1 have the product 1. The condition
/// stays smooth where this pair changes from complex to real. Empty where `along` is empty.
std::optional<Condition> pair_condition(const MonodromyJet& jet);

}  // namespace rubsweep::branch::curves
