#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <type_traits>
#include <variant>
#include <vector>

#include "rubsweep/core/integrate/exact/modes/linear_mode.hpp"
#include "rubsweep/core/integrate/exact/tangents_one_by_one.hpp"
#include "rubsweep/core/integrate/exact/tangents_side_by_side.hpp"

namespace rubsweep::integrate::exact {

/// Tangent vectors of an exact run: small disturbances of its state, moved by the derivative of the flow.
/// Inside a contact mode the law is linear, so that the derivative is the flow of the mode itself; it is
/// applied once per visit to the mode, over the whole time spent there, not once per step.
template <int N>
class TangentVectors {
 public:
  void clear();
  /// Begins with one vector per column, as TurnRequest::tangent_vectors of sections in this scale, in `mode`.
  void begin(const modes::LinearMode<N>& mode, const run::StateScale& scale, const Eigen::MatrixXd& vectors);
  /// The run has spent `duration_s` more in its mode.
  void pass(double duration_s) { lag_s_ += duration_s; }
  /// The run leaves mode `from` for `to`. The force is continuous there, so that tangent vectors go on
  /// without a jump (the saltation matrix is the identity); only their coordinates change.
  void change(const modes::LinearMode<N>& from, const modes::LinearMode<N>& to);
  /// The same by the change between both modes.
  void change(const modes::LinearMode<N>& from, const typename modes::ExactTypes<N>::Factor& by);
  /// One more from here on, (u, u') with time in seconds.
  void add(const modes::LinearMode<N>& mode, const typename modes::ExactTypes<N>::State& physical);
  /// Where they are now in the coordinates of `mode`, the present one.
  std::vector<typename modes::ExactTypes<N>::State> now(const modes::LinearMode<N>& mode);
  /// Products of each with a linear function of the free vibration there, times `unit`.
  void put_sums(const modes::LinearMode<N>& mode, const modes::ModalTerms& terms, double unit,
                modes::ModalSums& sums);
  /// Where the first ones are now, as many as `vectors` has columns.
  void put(const modes::LinearMode<N>& mode, const run::StateScale& scale, Eigen::MatrixXd& vectors);

 private:
  using State = typename modes::ExactTypes<N>::State;

  void catch_up(const modes::LinearMode<N>& mode);

  /// In the mode's coordinates.
  std::conditional_t<N == Eigen::Dynamic, std::variant<TangentsOneByOne<N>, TangentsSideBySide>,
                     std::variant<TangentsOneByOne<N>>>
      vectors_;
  double lag_s_ = 0;  ///< time behind the state
};

extern template class TangentVectors<2>;
extern template class TangentVectors<4>;
extern template class TangentVectors<6>;
extern template class TangentVectors<Eigen::Dynamic>;

}  // namespace rubsweep::integrate::exact
