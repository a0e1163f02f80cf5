#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>

#include "rubsweep/numerics/taylor_series.hpp"

namespace rubsweep::numerics {

/// One register of every x86-64 processor; wider ones would have to be taken apart where they are missing.
using Twin [[gnu::vector_size(16)]] = double;

inline Twin both(double value) { return Twin{value, value}; }
inline Twin swapped(Twin pair) { return __builtin_shufflevector(pair, pair, 1, 0); }
inline Twin first_twice(Twin pair) { return __builtin_shufflevector(pair, pair, 0, 0); }
inline Twin second_twice(Twin pair) { return __builtin_shufflevector(pair, pair, 1, 1); }
/// Without the signs' bits: one instruction.
inline Twin magnitudes(Twin pair) {
  using Bits [[gnu::vector_size(16)]] = std::int64_t;
  constexpr std::int64_t all_but_sign = std::numeric_limits<std::int64_t>::max();
  return std::bit_cast<Twin>(std::bit_cast<Bits>(pair) & Bits{all_but_sign, all_but_sign});
}
/// Twice.
inline Twin sum_of(Twin pair) { return pair + swapped(pair); }
/// That of the first, that of the second.
inline Twin sums_of(Twin first, Twin second) {
  return __builtin_shufflevector(first, second, 0, 2) + __builtin_shufflevector(first, second, 1, 3);
}
inline Twin larger(Twin one, Twin other) { return one < other ? other : one; }
inline Twin load(const double* from) {
  Twin pair;
  std::memcpy(&pair, from, sizeof pair);
  return pair;
}
inline void store(double* to, Twin pair) { std::memcpy(to, &pair, sizeof pair); }
/// 1 / k twice, 0 < k <= most_taylor_order + 2.
inline Twin reciprocal(int k) {
  static constexpr auto table = [] {
    std::array<double, 2 * taylor_reciprocals.size()> twice{};
    for (std::size_t i = 0; i < twice.size(); ++i) twice[i] = taylor_reciprocals[i / 2];
    return twice;
  }();
  return load(&table[2 * static_cast<std::size_t>(k)]);
}
/// x^0, x^1, ... , `count` of them: even and odd ones do not wait for each other.
inline void put_powers(double x, int count, double* to) {
  const Twin square = both(x * x);
  Twin powers{1, x};
  int k = 0;
  for (; k + 1 < count; k += 2, powers *= square) store(to + k, powers);
  if (k < count) to[k] = powers[0];
}
/// A quarter of a turn further: (-y, x).
inline Twin quarter_turned(Twin pair) { return Twin{-1, 1} * swapped(pair); }

/// Coefficients of the power series of a vector in a plane. That of a number has each of them twice. A
/// coefficient is one register, written and read as a whole: a product waits neither for one that was just
/// written nor for a sum across registers.
class PlaneSeries {
 public:
  Twin operator[](int k) const { return terms_[k]; }
  void set(int k, Twin value) { terms_[k] = value; }
  void set(int k, double value) { terms_[k] = both(value); }
  double number(int k) const { return terms_[k][0]; }

 private:
  Twin terms_[most_taylor_order + 2];  ///< one more than the order: a rate asks for the next
};

/// `Count` such series side by side: what is done with all of them alike waits less than what is done with
/// one after the other.
template <int Count>
class PlaneSeriesBundle {
 public:
  using Term = std::array<Twin, static_cast<std::size_t>(Count)>;  ///< coefficient of each
  const Term& operator[](int k) const { return terms_[k]; }
  void set(int k, const Term& value) { terms_[k] = value; }
  void set(int k, std::size_t which, Twin value) { terms_[k][which] = value; }

  /// One of them, as a PlaneSeries is read.
  struct Member {
    const PlaneSeriesBundle& all;
    std::size_t which;
    Twin operator[](int k) const { return all[k][which]; }
  };
  Member member(std::size_t which) const { return {*this, which}; }

 private:
  Term terms_[most_taylor_order + 2];
};

/// Sum of a_j b_{k-j}, component by component, for `first` <= j <= `last`; of series or members of
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

/// Coefficient k of a b, component by component.
template <class A, class B>
Twin product_term(const A& a, const B& b, int k) {
  return sum_of_products(a, b, k, 0, k);
}

}  // namespace rubsweep::numerics
