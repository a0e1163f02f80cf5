#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "rubsweep/core/numerics/root_below.hpp"
#include "rubsweep/core/numerics/twin.hpp"

namespace rubsweep::numerics {

/// Highest order of a power series here.
inline constexpr int most_taylor_order = 24;

/// Reciprocals 1 / k, each of them twice: divisions would be the critical path of such recurrences.
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

/// x^0, x^1, ... , `count` of them: even and odd ones do not wait for each other.
inline void put_powers(double x, int count, double* to) {
  const Twin square = both(x * x);
  Twin powers{1, x};
  int k = 0;
  for (; k + 1 < count; k += 2, powers *= square) store(to + k, powers);
  if (k < count) to[k] = powers[0];
}

/// The longest t, at most `longest`, with term t^k <= largest, of a term >= 0 and a k >= 1, or up to a
/// thousandth less. A root is drawn only where it is needed.
inline double longest_below(double longest, double term, int k, double largest) {
  return term * power(longest, k) > largest ? root_below(largest / term, k) : longest;
}

/// Coefficients of a power series sum a_k t^k, written one after the other. They are kept in both directions,
/// so that the sum over a_j b_{k-j} reads two rows of numbers forwards.
class Series {
 public:
  double operator[](int k) const { return forward_[k]; }
  void set(int k, double value) {
    forward_[k] = value;
    backward_[last - k] = value;
  }

  /// Sum of a_j b_{k-j} for 1 <= j <= end - 1 (end <= k): the inside of coefficient k of a product. Neither
  /// a_0, b_0 nor a_k, b_k is read, so that a recurrence may ask for it before it knows the latter.
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
  static constexpr int last = most_taylor_order + 1;  ///< one more than the order: a rate asks for the next
  double forward_[last + 1];
  double backward_[last + 1];
};

/// Sum of a_j a_{k-j} for 1 <= j <= k - 1, each pair taken once.
inline double inner_square(const Series& a, int k) {
  const int half = (k + 1) / 2;
  const double twice = 2 * inner_sum(a, a, k, half);
  return k % 2 == 0 && k > 0 ? twice + a[k / 2] * a[k / 2] : twice;
}

/// Coefficient k of a a.
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
      // sech^2 keeps its digits where tanh is near one.
      const double inverse = 1 / std::cosh(g * w_k);
      z.set(0, inverse * inverse);
      return;
    }
    y.set(k, (rate[k] * z[0] + inner_sum(rate, z, k)) * one_over(k));
    z.set(k, -square_term(y, k));
  }
};

/// y = exp(-x^p) with z = p x^(p-1) y, p being 1 or 2, by y' = -x' z. `rate` holds k x_k; written up to k.
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

}  // namespace rubsweep::numerics
