#pragma once

#include <cstddef>

namespace rubsweep::numerics {

/// Vectors stored side by side: number j of vector i is data[j * stride + i], 0 <= i < count. The processor
/// works on as many vectors at once as its registers are wide, and each vector gets the same bits as alone.
/// Storage is padded to a multiple of eight vectors; the padding is computed too.
struct SideBySide {
  double* data = nullptr;
  std::ptrdiff_t stride = 0, count = 0;

  /// SIMD width used for `count` vectors; storage is padded to a multiple of eight.
  static std::ptrdiff_t lanes(std::ptrdiff_t count) { return count > 4 ? 8 : count; }
  std::ptrdiff_t lanes() const { return lanes(count); }
  /// View of the same vectors that starts at number j.
  SideBySide from(std::ptrdiff_t j) const { return {data + j * stride, stride, count}; }
};

/// to = matrix . from for every vector, with the same bits as `multiply`. The matrix is stored by columns,
/// each `matrix_stride` numbers after the one before. `from` and `to` must not overlap; columns >= 1.
void multiply_each(std::ptrdiff_t rows, std::ptrdiff_t columns, const double* matrix,
                   std::ptrdiff_t matrix_stride, const SideBySide& from, const SideBySide& to);

/// Multiplies number j of every vector by factors[j * factor_stride], 0 <= j < n.
void scale_each(std::ptrdiff_t n, const double* factors, std::ptrdiff_t factor_stride, const SideBySide& z);

/// Moves the pairs (j, n + j) of every vector by their flows: uu, uv, vu, vv of n pairs in sequence.
void move_pairs_of_each(std::ptrdiff_t n, const double* flow, const SideBySide& z);

/// Next term of the series of u' = v, v' = -(spring + damper), forces per mass that depend linearly on (u,
/// v). (u, v) becomes `factor` times its rate and is added to z = (sum of u, sum of v), n numbers each.
void add_term_to_each(std::ptrdiff_t n, double factor, const SideBySide& spring, const SideBySide& damper,
                      const SideBySide& u, const SideBySide& v, const SideBySide& z);

}  // namespace rubsweep::numerics
