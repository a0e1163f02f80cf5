#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace rubsweep::ring {

/// Coefficients of det(lambda I - A) by the Faddeev-LeVerrier algorithm, highest power first (its coefficient
/// is 1). `matrix`: size x size, row by row. `Number`: any real number type.
template <class Number>
std::vector<Number> characteristic_polynomial(const std::vector<Number>& matrix, std::size_t size) {
  std::vector<Number> coefficients{Number(1)};
  std::vector<Number> auxiliary(size * size, Number(0)), product(size * size);
  for (std::size_t k = 1; k <= size; ++k) {
    // auxiliary = A auxiliary + c_{k-1} I
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t j = 0; j < size; ++j) {
        Number sum = i == j ? coefficients.back() : Number(0);
        for (std::size_t m = 0; m < size; ++m) sum += matrix[i * size + m] * auxiliary[m * size + j];
        product[i * size + j] = sum;
      }
    }
    auxiliary.swap(product);
    Number trace(0);
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t m = 0; m < size; ++m) trace += matrix[i * size + m] * auxiliary[m * size + i];
    }
    coefficients.push_back(-trace / Number(static_cast<double>(k)));
  }
  return coefficients;
}

/// Number of roots with positive real part of a polynomial (highest power first): sign changes in the first
/// column of its Routh array. Empty if this column contains a zero: a root is neutral, or the array is
/// degenerate.
template <class Number>
std::optional<int> routh_hurwitz_sign_changes(const std::vector<Number>& coefficients) {
  const std::size_t degree = coefficients.size() - 1;
  std::vector<Number> upper, lower;
  for (std::size_t i = 0; i <= degree; ++i) (i % 2 == 0 ? upper : lower).push_back(coefficients[i]);
  int changes = 0;
  for (std::size_t row = 0; row < degree; ++row) {
    lower.resize(upper.size(), Number(0));
    if (upper[0] == Number(0) || lower[0] == Number(0)) return std::nullopt;
    if ((upper[0] < Number(0)) != (lower[0] < Number(0))) ++changes;
    std::vector<Number> next;
    for (std::size_t i = 0; i + 1 < upper.size(); ++i) {
      next.push_back(upper[i + 1] - upper[0] * lower[i + 1] / lower[0]);
    }
    if (next.empty()) next.push_back(Number(0));
    upper = std::move(lower);
    lower = std::move(next);
  }
  return changes;
}

}  // namespace rubsweep::ring
