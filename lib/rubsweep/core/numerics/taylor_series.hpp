#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "rubsweep/core/numerics/twin.hpp"

namespace rubsweep::numerics {

/// The k-th root of x > 0, or up to 0.1 % less: accurate enough for a step length, in a quarter of the time
/// of std::pow. With x = 2^e (1 + f), polynomials approximate log2(1 + f) and the power of two. Low roots and
/// subnormal numbers use std::pow.
inline double root_below(double x, int k) {
  constexpr int least_root = 16, digits = 52, bias = 1023;
  using Limits = std::numeric_limits<double>;
  if (k < least_root || !(x >= Limits::min() && x <= Limits::max())) return std::pow(x, 1.0 / k);
  constexpr auto one = std::uint64_t{bias} << digits, fraction = (std::uint64_t{1} << digits) - 1;
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const double f = std::bit_cast<double>((bits & fraction) | one) - 1;
  // The error is below 0.01 and is divided by k in the root. `bias` makes the number positive, for which
  // conversion to an integer rounds down.
  const double logarithm = (static_cast<int>(bits >> digits) - bias + f * (4 - f) / 3) / k + bias;
  const auto whole = static_cast<std::uint64_t>(static_cast<std::int64_t>(logarithm));
  const double g = logarithm - static_cast<double>(static_cast<std::int64_t>(whole));
  // Relative error below 1.5e-4.
  const double power = 1 + g * (0.695976 + g * (0.224940 + g * 0.079084));
  constexpr double below = 1 - 4.5e-4;
  return below * power * std::bit_cast<double>(whole << digits);
}

inline constexpr int most_taylor_order = 24;  ///< Highest order of the power series in this file.

/// Table of 1 / k, each entry twice: divisions would be the slowest part of the recurrences.
inline constexpr auto taylor_reciprocals = [] {
  std::array<double, 2 * std::size_t{most_taylor_order + 3}> table{};
  for (std::size_t k = 1; 2 * k < table.size(); ++k)
    table[2 * k] = table[2 * k + 1] = 1 / static_cast<double>(k);
  return table;
}();
constexpr double one_over(int k) { return taylor_reciprocals[2 * static_cast<std::size_t>(k)]; }
inline Twin one_over_twice(int k) { return load(&taylor_reciprocals[2 * static_cast<std::size_t>(k)]); }

/// x^k, k >= 0.
constexpr double power(double x, int k) {
  double result = 1;
  for (; k > 0; k /= 2, x *= x) {
    if (k % 2 == 1) result *= x;
  }
  return result;
}

/// x^0, x^1, ..., `count` powers: even and odd ones are computed independently.
inline void put_powers(double x, int count, double* to) {
  const Twin square = both(x * x);
  Twin powers{1, x};
  int k = 0;
  for (; k + 1 < count; k += 2, powers *= square) store(to + k, powers);
  if (k < count) to[k] = powers[0];
}

/// The longest t <= `longest` with term t^k <= largest, for term >= 0 and k >= 1, or up to 0.1 % less. The
/// root is computed only if needed.
inline double longest_below(double longest, double term, int k, double largest) {
  return term * power(longest, k) > largest ? root_below(largest / term, k) : longest;
}

/// Coefficients of a power series sum a_k t^k, written in order. They are stored in both directions, so that
/// the sum of a_j b_{k-j} reads both arrays forwards.
class Series {
 public:
  double operator[](int k) const { return forward_[k]; }
  void set(int k, double value) {
    forward_[k] = value;
    backward_[last - k] = value;
  }

  /// Sum of a_j b_{k-j} for 1 <= j <= end - 1 (end <= k): the inner part of coefficient k of a product. It
  /// reads none of a_0, b_0, a_k, b_k, so that a recurrence may call it before a_k and b_k are known.
  friend double inner_sum(const Series& a, const Series& b, int k, int end) {
    const double *x = a.forward_, *y = b.backward_ + (last - k);
    Twin even{}, odd{};
    int j = 1;
    for (; j + 4 <= end; j += 4) {
      even += load(x + j) * load(y + j);
      odd += load(x + j + 2) * load(y + j + 2);
    }
    if (j + 2 <= end) {
      even += load(x + j) * load(y + j);
      j += 2;
    }
    even += odd;
    double sum = even[0] + even[1];
    if (j < end) sum += x[j] * y[j];
    return sum;
  }
  friend double inner_sum(const Series& a, const Series& b, int k) { return inner_sum(a, b, k, k); }

 private:
  static constexpr int last = most_taylor_order + 1;  ///< one more than the order, for the series of a rate
  double forward_[last + 1];
  double backward_[last + 1];
};

/// Coefficient k of the product a b.
inline double product_term(const Series& a, const Series& b, int k) {
  return k == 0 ? a[0] * b[0] : a[0] * b[k] + a[k] * b[0] + inner_sum(a, b, k);
}

/// Sum of a_j a_{k-j} for 1 <= j <= k - 1, each pair taken once.
inline double inner_square(const Series& a, int k) {
  const int half = (k + 1) / 2;
  const double twice = 2 * inner_sum(a, a, k, half);
  return k % 2 == 0 && k > 0 ? twice + a[k / 2] * a[k / 2] : twice;
}

/// Coefficient k of the product a a.
inline double square_term(const Series& a, int k) {
  return k == 0 ? a[0] * a[0] : 2 * a[0] * a[k] + inner_square(a, k);
}

/// y = tanh(g w) with z = 1 - y^2, by y' = g w' z. `rate` holds k w_k; y and z are written up to k.
struct TanhSeries {
  Series y, z, rate;

  void add_term(double g, double w_k, int k) {
    rate.set(k, k * g * w_k);
    if (k == 0) {
      y.set(0, std::tanh(g * w_k));
      // 1 / cosh^2 keeps its digits where tanh is near one.
      const double inverse = 1 / std::cosh(g * w_k);
      z.set(0, inverse * inverse);
      return;
    }
    y.set(k, (rate[k] * z[0] + inner_sum(rate, z, k)) * one_over(k));
    z.set(k, -square_term(y, k));
  }
};

/// y = exp(-x^p) with z = p x^(p-1) y, p = 1 or 2, by y' = -x' z. `rate` holds k x_k; all are known up to k.
struct FallSeries {
  Series x, y, z, rate;

  void add_term(int p, double x_k, int k) {
    x.set(k, x_k);
    rate.set(k, k * x_k);
    if (k == 0) {
      y.set(0, std::exp(p == 1 ? -x_k : -x_k * x_k));
      z.set(0, p == 1 ? y[0] : 2 * x_k * y[0]);
      return;
    }
    y.set(k, -(rate[k] * z[0] + inner_sum(rate, z, k)) * one_over(k));
    z.set(k, p == 1 ? y[k] : 2 * (x[0] * y[k] + x[k] * y[0] + inner_sum(x, y, k)));
  }
};

/// Coefficients of the power series of a plane vector; the series of a number holds each coefficient twice.
/// Each coefficient is one register, read and written as a whole, so that products need no sum across
/// registers.
class PlaneSeries {
 public:
  Twin operator[](int k) const { return terms_[k]; }
  void set(int k, Twin value) { terms_[k] = value; }
  void set(int k, double value) { terms_[k] = both(value); }
  double number(int k) const { return terms_[k][0]; }

 private:
  Twin terms_[most_taylor_order + 2];  ///< one more than the order, for the series of a rate
};

/// `Count` such series side by side: one operation on all of them at once waits less than on one after
/// another.
template <int Count>
class PlaneSeriesBundle {
 public:
  using Term = std::array<Twin, static_cast<std::size_t>(Count)>;  ///< coefficient of each series
  const Term& operator[](int k) const { return terms_[k]; }
  void set(int k, const Term& value) { terms_[k] = value; }
  void set(int k, std::size_t which, Twin value) { terms_[k][which] = value; }

  /// View of one series of the bundle, read like a PlaneSeries.
  struct Member {
    const PlaneSeriesBundle& all;
    std::size_t which;
    Twin operator[](int k) const { return all[k][which]; }
  };
  Member member(std::size_t which) const { return {*this, which}; }

 private:
  Term terms_[most_taylor_order + 2];
};

/// Sum of a_j b_{k-j}, component by component, for `first` <= j <= `last`; a and b are series or members of
/// bundles.
template <class A, class B>
Twin sum_of_products(const A& a, const B& b, int k, int first, int last) {
  Twin even{}, odd{};
  int j = first;
  for (; j < last; j += 2) {
    even += a[j] * b[k - j];
    odd += a[j + 1] * b[k - j - 1];
  }
  if (j == last) even += a[j] * b[k - j];
  return even + odd;
}

/// Coefficient k of the product a b, component by component.
template <class A, class B>
Twin product_term(const A& a, const B& b, int k) {
  return sum_of_products(a, b, k, 0, k);
}

}  // namespace rubsweep::numerics
