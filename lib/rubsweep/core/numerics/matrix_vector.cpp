#include "rubsweep/core/numerics/matrix_vector.hpp"

#include <cstring>

#include "rubsweep/core/numerics/lanes.hpp"

namespace rubsweep::numerics {
namespace {

/// `count` lanes of rows at once, each with its own independent sum. The last lane begins at row `last`.
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

/// All rows; there is at least one lane of them. Each pass handles several lanes, about equally many. The
/// very last lane is shifted back to end with the last row. Rows computed twice get the same bits.
template <std::size_t bytes>
[[gnu::always_inline]] inline void all_rows(std::ptrdiff_t rows, std::ptrdiff_t columns, const double* matrix,
                                            std::ptrdiff_t stride, const double* vector, double* product) {
  constexpr auto width = static_cast<std::ptrdiff_t>(bytes / sizeof(double));
  constexpr std::ptrdiff_t most = 6;  // lanes at a time: sums, entries and a factor fit into 16 registers
  std::ptrdiff_t lanes = (rows + width - 1) / width;
  for (std::ptrdiff_t passes = (lanes + most - 1) / most, first = 0; passes > 0; --passes) {
    const std::ptrdiff_t now = (lanes + passes - 1) / passes;
    const std::ptrdiff_t last = std::min((now - 1) * width, rows - width - first);
    with_known_count<std::size_t{most}>(
        now, [&]<std::size_t count>() __attribute__((always_inline)) {
          some_lanes<bytes, count>(columns, matrix + first, stride, last, vector, product + first);
        });
    lanes -= now;
    first += now * width;
  }
}

}  // namespace

void multiply(std::ptrdiff_t rows, std::ptrdiff_t columns, const double* matrix, std::ptrdiff_t stride,
              const double* vector, double* product) {
  if (rows == 1) {
    double sum = matrix[0] * vector[0];
    for (std::ptrdiff_t k = 1; k < columns; ++k) sum += matrix[k * stride] * vector[k];
    product[0] = sum;
    return;
  }
  in_widest_lanes(
      rows, [&]<std::size_t bytes>() __attribute__((always_inline)) {
        all_rows<bytes>(rows, columns, matrix, stride, vector, product);
      });
}

}  // namespace rubsweep::numerics
