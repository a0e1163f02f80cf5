#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "rubsweep/core/integrate/exact/modes/mode_flow.hpp"

namespace rubsweep::integrate::exact {

/// Tangent vectors in the coordinates of a contact mode, each stored as a separate state.
template <int N>
class TangentsOneByOne {
 public:
  using Types = modes::ExactTypes<N>;
  using State = typename Types::State;

  std::size_t size() const { return count_; }
  void clear() { count_ = 0; }
  /// Makes room for `count` vectors of any length; existing vectors stay.
  void resize(Eigen::Index /*numbers*/, std::size_t count) {
    if (list_.size() < count) list_.resize(count);
    count_ = count;
  }
  void set(std::size_t i, const State& z) { list_[i] = z; }
  State get(std::size_t i) const { return list_[i]; }

  void move(const typename Types::Pairs& flow) {
    for (State& z : in_use()) modes::move_pairs(flow, z);
  }
  void move(const typename Types::Factor& flow) {
    for (State& z : in_use()) {
      numerics::put_product(flow, z, moved_);
      z = moved_;
    }
  }
  void move_by_series(const modes::LinearMode<N>& mode, double duration_s) {
    for (State& z : in_use()) modes::move_by_series(mode, duration_s, z);
  }
  void change(const modes::LinearMode<N>& from, const modes::LinearMode<N>& to) {
    for (State& z : in_use()) {
      from.put_from_free(z, moved_);
      to.put_to_free(moved_, z);
    }
  }
  /// Sums of a linear function (ModalSum) for each vector, times `unit`.
  void see(const modes::ModalTerms& terms, bool paired, double unit, modes::ModalSums& sums) const {
    sums.resize(count_);
    for (std::size_t i = 0; i < count_; ++i) {
      const modes::ModalSum sum = modes::sum_of(terms.list, list_[i].data(), paired);
      sums.value[i] = unit * sum.value();
      sums.rate[i] = unit * sum.rate();
      sums.curvature[i] = unit * sum.curvature();
    }
  }

 private:
  std::span<State> in_use() { return std::span(list_).first(count_); }

  std::vector<State> list_;
  std::size_t count_ = 0;
  State moved_;  ///< scratch: a vector being moved
};

}  // namespace rubsweep::integrate::exact
