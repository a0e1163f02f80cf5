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

/// One term of a linear function of the free vibration z: a penetration, for example, is a fixed combination
/// of all modal coordinates, and what one mode of vibration adds to it is a term. It depends on the pair
/// (z_u, z_v) of that mode; in a contact mode without a modal form, on a displacement and its velocity.
struct ModalTerm {
  Eigen::Index u = 0, v = 0;
  double value_u = 0, value_v = 0;  ///< the term is value_u z_u + value_v z_v
  double rate_u = 0, rate_v = 0;    ///< its time derivative is rate_u z_u + rate_v z_v
  /// Bound of its second derivative over the mode's longest step from now: bound_u |(z_u, z_v)| with a modal
  /// form, bound_u |z_u| + bound_v |z_v| without one.
  double bound_u = 0, bound_v = 0;
  double envelope = 0;  ///< the term itself stays below envelope |(z_u, z_v)|; with a modal form only
};

/// A linear function of z as the list of its terms, those that are zero left out. Slow pairs stand before
/// fast ones. A function that depends on nothing has one term of zeros, so that there is always one to begin
/// a sum with.
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

/// A sum of such terms: their value, their time derivative, and a bound of their second derivative.
struct ModalSum {
  // What comes from u and from v is summed apart: the processor adds both at once.
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

/// Sum of one term or more at the state `z`.
inline ModalSum sum_of(std::span<const ModalTerm> pairs, const double* z, bool paired) {
  ModalSum sum(pairs.front(), z, paired);
  for (const ModalTerm& pair : pairs.subspan(1)) sum += ModalSum(pair, z, paired);
  return sum;
}

/// The terms of a function that is given by four rows of 2n numbers on z: its value, its time derivative, the
/// bound of its second derivative and the bound of itself. `fast` says which of the n pairs count as fast.
ModalTerms modal_terms(const Eigen::Matrix<double, 4, Eigen::Dynamic>& rows, const std::vector<bool>& fast);

}  // namespace rubsweep::integrate::exact
