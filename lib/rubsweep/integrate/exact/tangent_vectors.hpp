#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "rubsweep/integrate/exact/linear_mode.hpp"

namespace rubsweep::integrate::exact {

/// Tangent vectors of an exact run's state, which follow its contact modes: by the flow of a mode once per
/// visit to it, not once per step.
template <int N>
class TangentVectors {
 public:
  void clear() { count_ = 0; }
  /// One per column, as Turn::tangent_vectors, in `mode` from here on.
  void begin(const LinearMode<N>& mode, double speed_rad_per_s, const Eigen::MatrixXd& vectors);
  /// The run has gone on in its mode.
  void pass(double duration_s) { lag_s_ += duration_s; }
  /// The run leaves mode `from` for `to`: at a guard its state, and so its tangent vectors, go on without a
  /// jump.
  void change(const LinearMode<N>& from, const LinearMode<N>& to);
  /// One more from here on, (u, u') with time in seconds.
  void add(const LinearMode<N>& mode, const typename ExactTypes<N>::State& physical);
  /// Where they are now in the coordinates of `mode`, the present one.
  std::span<const typename ExactTypes<N>::State> now(const LinearMode<N>& mode) {
    catch_up(mode);
    return {list_.data(), count_};
  }
  /// Where they are now, column by column.
  void put(const LinearMode<N>& mode, double speed_rad_per_s, Eigen::MatrixXd& vectors);

 private:
  using State = typename ExactTypes<N>::State;

  void catch_up(const LinearMode<N>& mode);

  std::vector<State> list_;  ///< in the mode's coordinates
  std::size_t count_ = 0;    ///< the first ones are in use
  double lag_s_ = 0;         ///< behind the state
};

extern template class TangentVectors<2>;
extern template class TangentVectors<4>;
extern template class TangentVectors<6>;
extern template class TangentVectors<Eigen::Dynamic>;

}  // namespace rubsweep::integrate::exact
