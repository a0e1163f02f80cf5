#pragma once

#include "rubsweep/numerics/taylor_series.hpp"

namespace rubsweep::numerics {

/// One register of every x86-64 processor; wider ones would have to be taken apart where they are missing.
using Two [[gnu::vector_size(16)]] = double;

inline Two both(double value) { return Two{value, value}; }
inline double sum_of(Two pair) { return pair[0] + pair[1]; }
/// A quarter of a turn further: (-y, x).
inline Two quarter_turned(Two pair) { return Two{-pair[1], pair[0]}; }

/// Coefficients of the power series of a vector in a plane. That of a number has each of them twice. A
/// coefficient is one register, written and read as a whole: a product waits neither for one that was just
/// written nor for a sum across registers.
class PlaneSeries {
 public:
  Two operator[](int k) const { return terms_[k]; }
  void set(int k, Two value) { terms_[k] = value; }
  void set(int k, double value) { terms_[k] = both(value); }
  double number(int k) const { return terms_[k][0]; }

 private:
  Two terms_[most_taylor_order + 2];  ///< one more than the order: a rate asks for the next
};

/// Sum of a_j b_{k-j}, component by component, for `first` <= j <= `last`.
inline Two sum_of_products(const PlaneSeries& a, const PlaneSeries& b, int k, int first, int last) {
  Two even{}, odd{};
  int j = first;
  for (; j < last; j += 2) {
    even += a[j] * b[k - j];
    odd += a[j + 1] * b[k - j - 1];
  }
  if (j == last) even += a[j] * b[k - j];
  return even + odd;
}

/// Coefficient k of a b, component by component.
inline Two product_term(const PlaneSeries& a, const PlaneSeries& b, int k) {
  return sum_of_products(a, b, k, 0, k);
}

}  // namespace rubsweep::numerics
