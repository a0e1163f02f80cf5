#include "rubsweep/core/numerics/lanes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>

namespace rubsweep::numerics {
namespace {

TEST(Lanes, AreAsManyAsAskedForAtMost) {
  std::size_t before = 16;
  for (const std::ptrdiff_t most : {1, 2, 3, 4, 7, 8, 100}) {
    std::size_t found = 0;
    in_widest_lanes(
        most, [&]<std::size_t bytes>()
                  __attribute__((always_inline)) { found = sizeof(typename Lanes<bytes>::Type); });
    EXPECT_LE(found / sizeof(double), static_cast<std::size_t>(std::max<std::ptrdiff_t>(most, 2))) << most;
    EXPECT_GE(found, before);
    before = found;
  }
}

TEST(LanesWithKnownCount, CallsWithThatCount) {
  for (std::ptrdiff_t count = 1; count <= 6; ++count) {
    std::size_t seen = 0;
    with_known_count<6>(
        count, [&]<std::size_t known>() __attribute__((always_inline)) { seen = known; });
    EXPECT_EQ(seen, static_cast<std::size_t>(count));
  }
}

}  // namespace
}  // namespace rubsweep::numerics
