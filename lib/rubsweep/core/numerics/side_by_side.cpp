#include "rubsweep/core/numerics/side_by_side.hpp"

#include <cstring>

#include "rubsweep/core/numerics/lanes.hpp"

namespace rubsweep::numerics {
namespace {

/// Calls at(i) for the first vector number i of each lane.
template <std::size_t bytes, class At>
[[gnu::always_inline]] inline void for_each_lane(std::ptrdiff_t count, const At& at) {
  for (std::ptrdiff_t i = 0; i < count; i += static_cast<std::ptrdiff_t>(bytes / sizeof(double))) at(i);
}

/// `count` rows of a product for the lane at `from.data`, each row with its own independent sum.
template <std::size_t bytes, std::size_t count>
[[gnu::always_inline]] inline void some_rows(std::ptrdiff_t columns, const double* matrix,
                                             std::ptrdiff_t matrix_stride, const SideBySide& from,
                                             const SideBySide& to) {
  typename Lanes<bytes>::Type sums[count], entries;
  std::memcpy(&entries, from.data, bytes);
#pragma GCC unroll 8
  for (std::size_t r = 0; r < count; ++r) sums[r] = matrix[r] * entries;
  for (std::ptrdiff_t k = 1; k < columns; ++k) {
    std::memcpy(&entries, from.data + k * from.stride, bytes);
    const double* const column = matrix + k * matrix_stride;
#pragma GCC unroll 8
    for (std::size_t r = 0; r < count; ++r) sums[r] += column[r] * entries;
  }
#pragma GCC unroll 8
  for (std::size_t r = 0; r < count; ++r)
    std::memcpy(to.data + static_cast<std::ptrdiff_t>(r) * to.stride, &sums[r], bytes);
}

/// Computes all rows for one lane, with about equally many rows in each pass.
template <std::size_t bytes>
[[gnu::always_inline]] inline void all_rows(std::ptrdiff_t rows, std::ptrdiff_t columns, const double* matrix,
                                            std::ptrdiff_t matrix_stride, const SideBySide& from,
                                            const SideBySide& to) {
  constexpr std::ptrdiff_t most = 8;
  std::ptrdiff_t first = 0;
  for (std::ptrdiff_t passes = (rows + most - 1) / most; passes > 0; --passes) {
    const std::ptrdiff_t now = (rows - first + passes - 1) / passes;
    with_known_count<std::size_t{most}>(
        now, [&]<std::size_t count>() __attribute__((always_inline)) {
          some_rows<bytes, count>(columns, matrix + first, matrix_stride, from, to.from(first));
        });
    first += now;
  }
}

}  // namespace

void multiply_each(std::ptrdiff_t rows, std::ptrdiff_t columns, const double* matrix,
                   std::ptrdiff_t matrix_stride, const SideBySide& from, const SideBySide& to) {
  in_widest_lanes(
      from.lanes(), [&]<std::size_t bytes>() __attribute__((always_inline)) {
        for_each_lane<bytes>(
            from.count, [&](std::ptrdiff_t i) __attribute__((always_inline)) {
              const auto lane = [i](const SideBySide& all) {
                return SideBySide{all.data + i, all.stride, 1};
              };
              all_rows<bytes>(rows, columns, matrix, matrix_stride, lane(from), lane(to));
            });
      });
}

void scale_each(std::ptrdiff_t n, const double* factors, std::ptrdiff_t factor_stride, const SideBySide& z) {
  in_widest_lanes(
      z.lanes(), [&]<std::size_t bytes>() __attribute__((always_inline)) {
        for (std::ptrdiff_t j = 0; j < n; ++j) {
          for_each_lane<bytes>(
              z.count, [&](std::ptrdiff_t i) __attribute__((always_inline)) {
                double* const at = z.data + j * z.stride + i;
                typename Lanes<bytes>::Type x;
                std::memcpy(&x, at, bytes);
                x *= factors[j * factor_stride];
                std::memcpy(at, &x, bytes);
              });
        }
      });
}

void move_pairs_of_each(std::ptrdiff_t n, const double* flow, const SideBySide& z) {
  in_widest_lanes(
      z.lanes(), [&]<std::size_t bytes>() __attribute__((always_inline)) {
        for (std::ptrdiff_t j = 0; j < n; ++j) {
          const double uu = flow[j], uv = flow[n + j], vu = flow[2 * n + j], vv = flow[3 * n + j];
          double *const u = z.data + j * z.stride, *const v = z.data + (n + j) * z.stride;
          for_each_lane<bytes>(
              z.count, [&](std::ptrdiff_t i) __attribute__((always_inline)) {
                typename Lanes<bytes>::Type a, b;
                std::memcpy(&a, u + i, bytes);
                std::memcpy(&b, v + i, bytes);
                const auto moved = uu * a + uv * b, rate = vu * a + vv * b;
                std::memcpy(u + i, &moved, bytes);
                std::memcpy(v + i, &rate, bytes);
              });
        }
      });
}

void add_term_to_each(std::ptrdiff_t n, double factor, const SideBySide& spring, const SideBySide& damper,
                      const SideBySide& u, const SideBySide& v, const SideBySide& z) {
  in_widest_lanes(
      z.lanes(), [&]<std::size_t bytes>() __attribute__((always_inline)) {
        for (std::ptrdiff_t j = 0; j < n; ++j) {
          for_each_lane<bytes>(
              z.count, [&](std::ptrdiff_t i) __attribute__((always_inline)) {
                using Lane = typename Lanes<bytes>::Type;
                const std::ptrdiff_t at_u = j * u.stride + i, at_v = j * v.stride + i;
                Lane a, b, sum_u, sum_v;
                std::memcpy(&a, spring.data + j * spring.stride + i, bytes);
                std::memcpy(&b, damper.data + j * damper.stride + i, bytes);
                const Lane rate = -factor * (a + b);
                std::memcpy(&a, v.data + at_v, bytes);
                const Lane moved = factor * a;
                std::memcpy(u.data + at_u, &moved, bytes);
                std::memcpy(v.data + at_v, &rate, bytes);
                double *const to_u = z.data + j * z.stride + i, *const to_v = z.data + (n + j) * z.stride + i;
                std::memcpy(&sum_u, to_u, bytes);
                std::memcpy(&sum_v, to_v, bytes);
                sum_u += moved;
                sum_v += rate;
                std::memcpy(to_u, &sum_u, bytes);
                std::memcpy(to_v, &sum_v, bytes);
              });
        }
      });
}

}  // namespace rubsweep::numerics
