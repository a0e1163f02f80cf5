#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace rubsweep::integrate::taylor {

/// Order up to which each of `Count` tangent vectors is summed: until `wanted` successive terms are at most
/// `accuracy` times its largest terms, in displacements and in rates.
template <int Count>
class TangentConvergence {
 public:
  /// Largest magnitudes in a term of each vector.
  using Sizes = Eigen::Array<double, 1, Count>;

  /// Starts with the sizes at the start of the vectors.
  TangentConvergence(double accuracy, Sizes displacement, Sizes rate, int wanted = 2)
      : accuracy_(accuracy),
        wanted_(wanted),
        displacement_(std::move(displacement)),
        rate_(std::move(rate)) {}

  /// Adds the terms of order `k`; call it in order of k.
  void add(int k, const Sizes& displacement, const Sizes& rate) {
    // Read one by one: to load numbers in pairs directly after they were stored one by one would stall the
    // processor.
    for (std::size_t i = 0; i < orders_.size(); ++i) {
      const auto column = static_cast<Eigen::Index>(i);
      displacement_(column) = std::max(displacement_(column), displacement(column));
      rate_(column) = std::max(rate_(column), rate(column));
      const bool small = displacement(column) <= accuracy_ * displacement_(column) &&
                         rate(column) <= accuracy_ * rate_(column);
      small_in_a_row_[i] = small ? small_in_a_row_[i] + 1 : 0;
      if (small_in_a_row_[i] < wanted_ || orders_[i] > 0) continue;
      orders_[i] = k;
      --left_;
    }
  }

  bool all_converged() const { return left_ == 0; }
  /// Order at which vector `i` converged; `most` where it did not.
  int order(std::size_t i, int most) const { return orders_[i] > 0 ? orders_[i] : most; }

 private:
  double accuracy_;
  int wanted_;
  Sizes displacement_, rate_;  ///< largest terms so far
  std::array<int, static_cast<std::size_t>(Count)> small_in_a_row_{}, orders_{};
  int left_ = Count;
};

}  // namespace rubsweep::integrate::taylor
