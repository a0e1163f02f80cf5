#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "rubsweep/core/numerics/twin.hpp"

namespace rubsweep::integrate::exact::modes {

/// Upper bound of the length of (u, v), at most 12 % above it, in both places.
inline numerics::Twin pair_size(numerics::Twin pair) {
  const numerics::Twin one = numerics::magnitudes(pair), other = numerics::swapped(one);
  return numerics::larger(one, other) + 0.5 * numerics::smaller(one, other);
}
inline double pair_size(double u, double v) { return pair_size(numerics::Twin{u, v})[0]; }

/// One term of a linear function of the free vibration z. For example, a penetration is a fixed combination
/// of all modal coordinates, and the contribution of one mode of vibration is a term. It depends on the pair
/// (z_u, z_v) of that mode, or without a modal form on a displacement and its velocity.
struct ModalTerm {
  Eigen::Index u = 0, v = 0;
  // Factors for z_u and z_v.
  numerics::Twin value{};  ///< the term is value . (z_u, z_v)
  numerics::Twin rate{};   ///< time derivative: rate . (z_u, z_v)
  /// Bound of its second derivative over the mode's longest step from now. With a modal form the bound is
  /// bound[0] |(z_u, z_v)|, and bound[1] is zero. Without a modal form it is bound . (|z_u|, |z_v|).
  numerics::Twin bound{};
  double envelope = 0;  ///< the term is at most envelope |(z_u, z_v)|; only with a modal form
};

/// A linear function of z as the list of its non-zero terms, slow pairs before fast ones. A constant function
/// has one term of zeros, so that every sum can start with a term.
struct ModalTerms {
  std::vector<ModalTerm> list;
  std::size_t slow_count = 0;

  std::span<const ModalTerm> slow() const { return {list.begin(), first_fast()}; }
  std::span<const ModalTerm> fast() const { return {first_fast(), list.end()}; }

 private:
  std::vector<ModalTerm>::const_iterator first_fast() const {
    return list.begin() + static_cast<std::ptrdiff_t>(slow_count);
  }
};

/// A sum of modal terms: value, time derivative, and a bound of the second derivative. Parts from z_u and
/// from z_v are summed separately, because the processor adds both at once.
class ModalSum {
 public:
  /// `paired`: whether z has a modal form.
  ModalSum(const ModalTerm& term, const double* z, bool paired) {
    const numerics::Twin pair{z[term.u], z[term.v]};
    value_ = term.value * pair;
    rate_ = term.rate * pair;
    bound_ = term.bound * (paired ? pair_size(pair) : numerics::magnitudes(pair));
  }

  void operator+=(const ModalSum& other) {
    value_ += other.value_;
    rate_ += other.rate_;
    bound_ += other.bound_;
  }

  double value() const { return value_[0] + value_[1]; }
  double rate() const { return rate_[0] + rate_[1]; }
  double curvature() const { return bound_[0] + bound_[1]; }

 private:
  numerics::Twin value_, rate_, bound_;
};

/// Sum of at least one term at the state `z`.
inline ModalSum sum_of(std::span<const ModalTerm> pairs, const double* z, bool paired) {
  ModalSum sum(pairs.front(), z, paired);
  for (const ModalTerm& pair : pairs.subspan(1)) sum += ModalSum(pair, z, paired);
  return sum;
}

/// Sums of modal terms for many states, one number per state.
struct ModalSums {
  std::vector<double> value, rate, curvature;

  void resize(std::size_t count) {
    value.resize(count);
    rate.resize(count);
    curvature.resize(count);
  }
};

/// Terms of a function given by four rows of 2n numbers on z: its value, its time derivative, the bound of
/// its second derivative, and the bound of its value. `fast` tells which of the n pairs are fast.
ModalTerms modal_terms(const Eigen::Matrix<double, 4, Eigen::Dynamic>& rows, const std::vector<bool>& fast);

}  // namespace rubsweep::integrate::exact::modes
