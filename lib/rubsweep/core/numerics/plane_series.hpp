#pragma once

#include <array>

#include "rubsweep/core/numerics/taylor_series.hpp"
#include "rubsweep/core/numerics/twin.hpp"

namespace rubsweep::numerics {

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
