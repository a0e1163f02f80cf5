#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace rubsweep::integrate::taylor {

/// Order up to which each of `Count` tangent vectors is summed: until two terms in a row are `accuracy` of
/// its largest ones, in displacements and in rates.
template <int Count>
class TangentConvergence {
 public:
  /// Largest magnitudes in a term of each vector.
  using Sizes = Eigen::Array<double, 1, Count>;

  /// From the sizes where the vectors start.
  TangentConvergence(double accuracy, Sizes displacement, Sizes rate)
      : accuracy_(accuracy), displacement_(std::move(displacement)), rate_(std::move(rate)) {}

  /// The terms of order `k`, in their order.
  void add(int k, const Sizes& displacement, const Sizes& rate) {
    // Number by number, as they were written: pairs of them would wait for each other.
    for (std::size_t i = 0; i < orders_.size(); ++i) {
      const auto column = static_cast<Eigen::Index>(i);
      displacement_(column) = std::max(displacement_(column), displacement(column));
      rate_(column) = std::max(rate_(column), rate(column));
      const bool small = displacement(column) <= accuracy_ * displacement_(column) &&
                         rate(column) <= accuracy_ * rate_(column);
      small_in_a_row_[i] = small ? small_in_a_row_[i] + 1 : 0;
      if (small_in_a_row_[i] < 2 || orders_[i] > 0) continue;
      orders_[i] = k;
      --left_;
    }
  }

  bool all_converged() const { return left_ == 0; }
  /// Order at which vector `i` converged; `most` where it did not.
  int order(std::size_t i, int most) const { return orders_[i] > 0 ? orders_[i] : most; }

 private:
  double accuracy_;
  Sizes displacement_, rate_;  ///< the largest so far
  std::array<int, static_cast<std::size_t>(Count)> small_in_a_row_{}, orders_{};
  int left_ = Count;
};

}  // namespace rubsweep::integrate::taylor
