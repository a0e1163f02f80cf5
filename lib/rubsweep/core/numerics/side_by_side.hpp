#pragma once

#include <cstddef>

namespace rubsweep::numerics {

/// Vectors side by side: number j of vector i is data[j * stride + i], 0 <= i < count. The processor works on
/// as many vectors at once as its registers are wide, and every vector gets the bits that it would get alone.
/// Storage is padded to a multiple of eight vectors, and the padding is computed along with them.
struct SideBySide {
  double* data = nullptr;
  std::ptrdiff_t stride = 0, count = 0;

  /// SIMD width used for `count` vectors; storage is padded to a multiple of eight.
  static std::ptrdiff_t lanes(std::ptrdiff_t count) { return count > 4 ? 8 : count; }
  std::ptrdiff_t lanes() const { return lanes(count); }
  /// The same vectors from number j on.
  SideBySide from(std::ptrdiff_t j) const { return {data + j * stride, stride, count}; }
};

/// to = matrix . from for every vector, the matrix column by column, each `matrix_stride` numbers behind the
/// one before, with the bits of `multiply`. `from` and `to` must not overlap; columns >= 1.
void multiply_each(std::ptrdiff_t rows, std::ptrdiff_t columns, const double* matrix,
                   std::ptrdiff_t matrix_stride, const SideBySide& from, const SideBySide& to);

/// Multiplies number j of every vector by factors[j * factor_stride], 0 <= j < n.
void scale_each(std::ptrdiff_t n, const double* factors, std::ptrdiff_t factor_stride, const SideBySide& z);

/// Moves the pairs (j, n + j) of every vector by their flows: uu, uv, vu, vv of n pairs one after the other.
void move_pairs_of_each(std::ptrdiff_t n, const double* flow, const SideBySide& z);

/// The next term of the series of u' = v, v' = -(spring + damper), forces per mass as (u, v) makes them: (u,
/// v) becomes `factor` times its rate and is added to z = (sum of u, sum of v), n numbers each.
void add_term_to_each(std::ptrdiff_t n, double factor, const SideBySide& spring, const SideBySide& damper,
                      const SideBySide& u, const SideBySide& v, const SideBySide& z);

}  // namespace rubsweep::numerics
