#include "rubsweep/numerics/matrix_vector.hpp"

#include <cstring>

namespace rubsweep::numerics {
namespace {

template <std::size_t bytes>
struct Lanes {
  // NOLINTNEXTLINE(modernize-use-using): an attribute that depends on a parameter
  typedef double Type __attribute__((vector_size(bytes)));
};

/// `count` lanes of rows at once, each with a sum of its own that waits for no other.
template <std::size_t bytes, std::size_t count>
[[gnu::always_inline]] inline void some_rows(std::ptrdiff_t rows, std::ptrdiff_t columns,
                                             const double* matrix, const double* vector, double* product) {
  using Lane = typename Lanes<bytes>::Type;
  Lane sums[count];
  for (std::size_t i = 0; i < count; ++i) {
    Lane entries;
    std::memcpy(&entries, reinterpret_cast<const char*>(matrix) + i * bytes, bytes);
    sums[i] = entries * vector[0];
  }
  for (std::ptrdiff_t k = 1; k < columns; ++k) {
    const char* column = reinterpret_cast<const char*>(matrix + k * rows);
    const double factor = vector[k];
#pragma GCC unroll 8
    for (std::size_t i = 0; i < count; ++i) {
      Lane entries;
      std::memcpy(&entries, column + i * bytes, bytes);
      sums[i] += entries * factor;
    }
  }
  std::memcpy(product, sums, sizeof sums);
}

template <std::size_t bytes>
[[gnu::always_inline]] inline void all_rows(std::ptrdiff_t rows, std::ptrdiff_t columns, const double* matrix,
                                            const double* vector, double* product) {
  constexpr auto lanes = static_cast<std::ptrdiff_t>(bytes / sizeof(double));
  std::ptrdiff_t i = 0;
  for (; i + 6 * lanes <= rows; i += 6 * lanes)
    some_rows<bytes, 6>(rows, columns, matrix + i, vector, product + i);
  for (; i + 2 * lanes <= rows; i += 2 * lanes)
    some_rows<bytes, 2>(rows, columns, matrix + i, vector, product + i);
  for (; i + 2 <= rows; i += 2) some_rows<16, 1>(rows, columns, matrix + i, vector, product + i);
  for (; i < rows; ++i) {
    double sum = matrix[i] * vector[0];
    for (std::ptrdiff_t k = 1; k < columns; ++k) sum += matrix[k * rows + i] * vector[k];
    product[i] = sum;
  }
}

using Multiply = void (*)(std::ptrdiff_t, std::ptrdiff_t, const double*, const double*, double*);

void by_two(std::ptrdiff_t rows, std::ptrdiff_t columns, const double* matrix, const double* vector,
            double* product) {
  all_rows<16>(rows, columns, matrix, vector, product);
}

#ifdef __x86_64__
[[gnu::target("avx")]] void by_four(std::ptrdiff_t rows, std::ptrdiff_t columns, const double* matrix,
                                    const double* vector, double* product) {
  all_rows<32>(rows, columns, matrix, vector, product);
}

Multiply fastest() { return __builtin_cpu_supports("avx") ? by_four : by_two; }
#else
Multiply fastest() { return by_two; }
#endif

}  // namespace

void multiply(std::ptrdiff_t rows, std::ptrdiff_t columns, const double* matrix, const double* vector,
              double* product) {
  static const Multiply multiply_here = fastest();
  multiply_here(rows, columns, matrix, vector, product);
}

}  // namespace rubsweep::numerics
