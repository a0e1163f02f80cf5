#pragma once

#include <Eigen/Core>
#include <variant>
#include <vector>

#include "rubsweep/core/integrate/exact/modes/linear_mode.hpp"
#include "rubsweep/core/integrate/exact/tangents_one_by_one.hpp"
#include "rubsweep/core/integrate/exact/tangents_side_by_side.hpp"

namespace rubsweep::integrate::exact {

/// Tangent vectors of an exact run: small disturbances of its state, moved by the derivative of the flow.
/// Inside a contact mode the law is linear, so that this derivative is the flow of the mode itself. It is
/// applied once per visit to the mode, for the whole time spent there, not once per step.
template <int N>
class TangentVectors {
 public:
  void clear();
  /// Begins in `mode` with one vector per column, given as TurnRequest::tangent_vectors for sections in this
  /// scale.
  void begin(const modes::LinearMode<N>& mode, const run::StateScale& scale, const Eigen::MatrixXd& vectors);
  /// Notes that the run has spent a further `duration_s` in its mode.
  void pass(double duration_s) { lag_s_ += duration_s; }
  /// Changes from mode `from` to `to`. The force is continuous there, so that tangent vectors do not jump
  /// (the saltation matrix is the identity); only their coordinates change.
  void change(const modes::LinearMode<N>& from, const modes::LinearMode<N>& to);
  /// Changes from mode `from` by the transformation `by` to the next mode.
  void change(const modes::LinearMode<N>& from, const typename modes::ExactTypes<N>::Factor& by);
  /// Adds a tangent vector, (u, u') with time in seconds.
  void add(const modes::LinearMode<N>& mode, const typename modes::ExactTypes<N>::State& physical);
  /// Present tangent vectors in the coordinates of `mode`, the present mode.
  std::vector<typename modes::ExactTypes<N>::State> now(const modes::LinearMode<N>& mode);
  /// Products of each vector with a linear function of the free vibration, times `unit`.
  void put_sums(const modes::LinearMode<N>& mode, const modes::ModalTerms& terms, double unit,
                modes::ModalSums& sums);
  /// Writes the first vectors, as many as `vectors` has columns.
  void put(const modes::LinearMode<N>& mode, const run::StateScale& scale, Eigen::MatrixXd& vectors);

 private:
  using State = typename modes::ExactTypes<N>::State;

  void catch_up(const modes::LinearMode<N>& mode);

  /// Vectors in the coordinates of the mode.
  std::variant<TangentsOneByOne<N>, TangentsSideBySide<N>> vectors_;
  double lag_s_ = 0;  ///< time by which they are behind the state
};

}  // namespace rubsweep::integrate::exact
