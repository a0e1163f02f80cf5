#include "rubsweep/numerics/matrix_vector.hpp"

#include <algorithm>
#include <cstring>

namespace rubsweep::numerics {
namespace {

template <std::size_t bytes>
struct Lanes {
  // NOLINTNEXTLINE(modernize-use-using): an attribute that depends on a parameter
  typedef double Type __attribute__((vector_size(bytes)));
};

/// `count` lanes of rows at once, each with a sum of its own that waits for no other. The last one begins at
/// row `last`.
template <std::size_t bytes, std::size_t count>
[[gnu::always_inline]] inline void some_lanes(std::ptrdiff_t columns, const double* matrix,
                                              std::ptrdiff_t stride, std::ptrdiff_t last,
                                              const double* vector, double* product) {
  using Lane = typename Lanes<bytes>::Type;
  constexpr std::size_t width = bytes / sizeof(double);
  const auto row_of = [last](std::size_t i) { return i + 1 < count ? i * width : std::size_t(last); };
  Lane sums[count];
#pragma GCC unroll 8
  for (std::size_t i = 0; i < count; ++i) {
    Lane entries;
    std::memcpy(&entries, matrix + row_of(i), bytes);
    sums[i] = entries * vector[0];
  }
  for (std::ptrdiff_t k = 1; k < columns; ++k) {
    const double* const column = matrix + k * stride;
    const double factor = vector[k];
#pragma GCC unroll 8
    for (std::size_t i = 0; i < count; ++i) {
      Lane entries;
      std::memcpy(&entries, column + row_of(i), bytes);
      sums[i] += entries * factor;
    }
  }
#pragma GCC unroll 8
  for (std::size_t i = 0; i < count; ++i) std::memcpy(product + row_of(i), &sums[i], bytes);
}

/// All rows, at least as many as a lane has: lanes side by side, about as many at a time in every pass, and
/// the very last one shifted back to end with the last row. What it makes again has the same bits.
template <std::size_t bytes>
[[gnu::always_inline]] inline void all_rows(std::ptrdiff_t rows, std::ptrdiff_t columns, const double* matrix,
                                            std::ptrdiff_t stride, const double* vector, double* product) {
  constexpr auto width = static_cast<std::ptrdiff_t>(bytes / sizeof(double));
  constexpr std::ptrdiff_t most = 6;  // at a time: sums, entries and a factor fit into sixteen registers
  std::ptrdiff_t lanes = (rows + width - 1) / width;
  for (std::ptrdiff_t passes = (lanes + most - 1) / most, first = 0; passes > 0; --passes) {
    const std::ptrdiff_t now = (lanes + passes - 1) / passes;
    const std::ptrdiff_t last = std::min((now - 1) * width, rows - width - first);
    const auto go = [&]<std::size_t count>() __attribute__((always_inline)) {
      some_lanes<bytes, count>(columns, matrix + first, stride, last, vector, product + first);
    };
    switch (now) {
      case 1:
        go.template operator()<1>();
        break;
      case 2:
        go.template operator()<2>();
        break;
      case 3:
        go.template operator()<3>();
        break;
      case 4:
        go.template operator()<4>();
        break;
      case 5:
        go.template operator()<5>();
        break;
      default:
        go.template operator()<6>();
    }
    lanes -= now;
    first += now * width;
  }
}

using Multiply = void (*)(std::ptrdiff_t, std::ptrdiff_t, const double*, std::ptrdiff_t, const double*,
                          double*);

void by_two(std::ptrdiff_t rows, std::ptrdiff_t columns, const double* matrix, std::ptrdiff_t stride,
            const double* vector, double* product) {
  if (rows >= 2) return all_rows<16>(rows, columns, matrix, stride, vector, product);
  double sum = matrix[0] * vector[0];
  for (std::ptrdiff_t k = 1; k < columns; ++k) sum += matrix[k * stride] * vector[k];
  product[0] = sum;
}

#ifdef __x86_64__
[[gnu::target("avx")]] void by_four(std::ptrdiff_t rows, std::ptrdiff_t columns, const double* matrix,
                                    std::ptrdiff_t stride, const double* vector, double* product) {
  if (rows < 4) return by_two(rows, columns, matrix, stride, vector, product);
  all_rows<32>(rows, columns, matrix, stride, vector, product);
}

[[gnu::target("avx512f")]] void by_eight(std::ptrdiff_t rows, std::ptrdiff_t columns, const double* matrix,
                                         std::ptrdiff_t stride, const double* vector, double* product) {
  if (rows < 8) return by_four(rows, columns, matrix, stride, vector, product);
  all_rows<64>(rows, columns, matrix, stride, vector, product);
}

Multiply fastest() {
  if (__builtin_cpu_supports("avx512f")) return by_eight;
  return __builtin_cpu_supports("avx") ? by_four : by_two;
}
#else
Multiply fastest() { return by_two; }
#endif

}  // namespace

void multiply(std::ptrdiff_t rows, std::ptrdiff_t columns, const double* matrix, std::ptrdiff_t stride,
              const double* vector, double* product) {
  static const Multiply multiply_here = fastest();
  multiply_here(rows, columns, matrix, stride, vector, product);
}

}  // namespace rubsweep::numerics
