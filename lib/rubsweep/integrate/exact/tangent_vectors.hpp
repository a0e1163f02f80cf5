#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "rubsweep/integrate/exact/linear_mode.hpp"

namespace rubsweep::integrate::exact {

/// Tangent vectors of an exact run: small disturbances of its state, moved by the derivative of the flow.
/// Inside a contact mode the law is linear, so that the derivative is the flow of the mode itself; it is
/// applied once per visit to the mode, over the whole time spent there, not once per step.
template <int N>
class TangentVectors {
 public:
  void clear() { count_ = 0; }
  /// One per column, as TurnRequest::tangent_vectors of sections in this scale, in `mode` from here on.
  void begin(const LinearMode<N>& mode, const run::StateScale& scale, const Eigen::MatrixXd& vectors);
  /// The run has gone on in its mode.
  void pass(double duration_s) { lag_s_ += duration_s; }
  /// The run leaves mode `from` for `to`. The force is continuous there, so that tangent vectors go on
  /// without a jump (the saltation matrix is the identity); only their coordinates change.
  void change(const LinearMode<N>& from, const LinearMode<N>& to);
  /// One more from here on, (u, u') with time in seconds.
  void add(const LinearMode<N>& mode, const typename ExactTypes<N>::State& physical);
  /// Where they are now in the coordinates of `mode`, the present one.
  std::span<const typename ExactTypes<N>::State> now(const LinearMode<N>& mode) {
    catch_up(mode);
    return {list_.data(), count_};
  }
  /// Where the first ones are now, as many as `vectors` has columns.
  void put(const LinearMode<N>& mode, const run::StateScale& scale, Eigen::MatrixXd& vectors);

 private:
  using State = typename ExactTypes<N>::State;

  void catch_up(const LinearMode<N>& mode);

  std::vector<State> list_;  ///< in the mode's coordinates
  std::size_t count_ = 0;    ///< the first ones are in use
  double lag_s_ = 0;         ///< behind the state
  State moved_;              ///< one of them on its way
};

extern template class TangentVectors<2>;
extern template class TangentVectors<4>;
extern template class TangentVectors<6>;
extern template class TangentVectors<Eigen::Dynamic>;

}  // namespace rubsweep::integrate::exact
