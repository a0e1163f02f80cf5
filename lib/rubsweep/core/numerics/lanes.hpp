#pragma once

#include <cstddef>

namespace rubsweep::numerics {

/// SIMD register of `bytes` bytes: the processor works on all its numbers at once.
template <std::size_t bytes>
struct Lanes {
  // NOLINTNEXTLINE(modernize-use-using): an attribute that depends on a parameter
  typedef double Type __attribute__((vector_size(bytes)));
};

#ifdef __x86_64__
template <class Kernel>
[[gnu::target("avx")]] void in_four_lanes(const Kernel& kernel) {
  kernel.template operator()<32>();
}
template <class Kernel>
[[gnu::target("avx512f")]] void in_eight_lanes(const Kernel& kernel) {
  kernel.template operator()<64>();
}

/// Number of doubles in the widest registers of this processor.
inline std::ptrdiff_t widest_lanes() {
  static const std::ptrdiff_t lanes = __builtin_cpu_supports("avx512f") ? 8
                                      : __builtin_cpu_supports("avx")   ? 4
                                                                        : 2;
  return lanes;
}
#endif

/// Calls `kernel.operator()<bytes>()` for the widest registers of this processor, with two to `most` lanes.
/// The kernel and everything it calls must be always inlined, so that they are compiled for these registers.
/// Each lane computes like a single number, so that the results do not depend on the processor.
template <class Kernel>
void in_widest_lanes([[maybe_unused]] std::ptrdiff_t most, const Kernel& kernel) {
#ifdef __x86_64__
  const std::ptrdiff_t widest = widest_lanes();
  if (widest >= 8 && most >= 8) return in_eight_lanes(kernel);
  if (widest >= 4 && most >= 4) return in_four_lanes(kernel);
#endif
  kernel.template operator()<16>();
}

/// Calls `use.operator()<n>()` with n = `count`, 1 <= count <= `most`, as a compile-time constant.
template <std::size_t most, class Use>
[[gnu::always_inline]] inline void with_known_count(std::ptrdiff_t count, const Use& use) {
  if constexpr (most > 1) {
    if (count < static_cast<std::ptrdiff_t>(most)) return with_known_count<most - 1>(count, use);
  }
  use.template operator()<most>();
}

}  // namespace rubsweep::numerics
