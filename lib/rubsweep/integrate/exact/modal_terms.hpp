#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace rubsweep::integrate::exact {

/// Upper bound of the length of (u, v), at most 12 % above it.
inline double pair_size(double u, double v) {
  const double a = std::abs(u), b = std::abs(v);
  return std::max(a, b) + 0.5 * std::min(a, b);
}

/// What a linear function of the free vibration z sees of one pair (z_u, z_v) of a modal form, or of a
/// coordinate and its rate where there is none.
struct ModalTerm {
  Eigen::Index u = 0, v = 0;
  double value_u = 0, value_v = 0;  ///< per unit of each
  double rate_u = 0, rate_v = 0;    ///< the function's rate, the same
  /// What a unit of size can do to the second derivative within the mode's longest step: of the pair, in
  /// `bound_u` alone, or of each component.
  double bound_u = 0, bound_v = 0;
  double envelope = 0;  ///< the same for the function itself
};

/// A linear function of z by the pairs that it does see, slow ones first; where it sees none, by one that
/// adds nothing.
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

/// Value, rate and bound on the second derivative of such a function, pair by pair.
struct ModalSum {
  // By u and by v apart, so that neither sum waits for the other.
  double value_u, value_v, rate_u, rate_v, bound_u, bound_v;

  /// `paired`: z has a modal form.
  ModalSum(const ModalTerm& pair, const double* z, bool paired) {
    const double u = z[pair.u], v = z[pair.v];
    value_u = pair.value_u * u;
    value_v = pair.value_v * v;
    rate_u = pair.rate_u * u;
    rate_v = pair.rate_v * v;
    bound_u = pair.bound_u * (paired ? pair_size(u, v) : std::abs(u));
    bound_v = paired ? 0 : pair.bound_v * std::abs(v);
  }

  void operator+=(const ModalSum& other) {
    value_u += other.value_u;
    value_v += other.value_v;
    rate_u += other.rate_u;
    rate_v += other.rate_v;
    bound_u += other.bound_u;
    bound_v += other.bound_v;
  }

  double value() const { return value_u + value_v; }
  double rate() const { return rate_u + rate_v; }
  double curvature() const { return bound_u + bound_v; }
};

/// Of one pair or more.
inline ModalSum sum_of(std::span<const ModalTerm> pairs, const double* z, bool paired) {
  ModalSum sum(pairs.front(), z, paired);
  for (const ModalTerm& pair : pairs.subspan(1)) sum += ModalSum(pair, z, paired);
  return sum;
}

/// Of a function whose value, rate, bound of the second derivative and bound of itself are these rows on z,
/// each of 2n numbers; `fast` says which of the n pairs are.
ModalTerms modal_terms(const Eigen::Matrix<double, 4, Eigen::Dynamic>& rows, const std::vector<bool>& fast);

}  // namespace rubsweep::integrate::exact
