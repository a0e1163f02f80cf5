#include "rubsweep/maps/sweep/attractors.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rubsweep::sweep {
namespace {

SampledMotion orbit(double length_m, double backward_m = 0.1) {
  return {"subharmonic 1/2", false, true, true, {length_m, 1, backward_m}};
}

Basins tell_apart(const std::vector<SampledMotion>& motions) {
  AttractorCount count;
  for (const SampledMotion& motion : motions) count.add(motion);
  return count.basins();
}

TEST(AttractorsAttractorCount, CountsOrbitsFailedStartsAndWhatNeverRepeats) {
  const SampledMotion failed{"failed", true, false, false, {}};
  const SampledMotion chaos{"chaotic", false, true, false, {3, 2, 1}},
      more_chaos{"chaotic", false, true, false, {1, 1, 1}};
  const Basins basins =
      tell_apart({orbit(2, 0.11), failed, orbit(2), chaos, orbit(2 + 1e-6), more_chaos, orbit(2 - 1e-6)});
  ASSERT_EQ(basins.attractors.size(), 3u);
  EXPECT_EQ(basins.failed, 1u);
  EXPECT_EQ(basins.numbers, (std::vector<int>{3, 0, 1, 2, 1, 2, 1}));
  EXPECT_EQ(basins.attractors[0].samples, 3u);
  EXPECT_EQ(basins.attractors[0].motion.orbit_m[0], 2);
  EXPECT_EQ(basins.attractors[1].motion.orbit_m[0], 3);
  EXPECT_NEAR(basins.attractors[0].share, 3.0 / 7, 1e-15);
  EXPECT_NEAR(basins.attractors[0].standard_error, std::sqrt(3.0 / 7 * 4 / 7 / 7), 1e-15);
}

TEST(AttractorsAttractorCount, ByAThousandthOfTheLargestLength) {
  EXPECT_EQ(tell_apart({orbit(2), orbit(2.0019)}).attractors.size(), 1u);
  EXPECT_EQ(tell_apart({orbit(2), orbit(2.0021)}).attractors.size(), 2u);
  EXPECT_EQ(tell_apart({orbit(2, 0.1), orbit(2, 0.1019)}).attractors.size(), 1u);
  EXPECT_EQ(tell_apart({orbit(2, 0.1), orbit(2, 0.1021)}).attractors.size(), 2u);
}

TEST(AttractorsAttractorCount, EquallyFrequentOnesInTheOrderInWhichTheyAreMet) {
  EXPECT_EQ(tell_apart({orbit(5), orbit(4), orbit(4), orbit(5)}).numbers, (std::vector<int>{1, 2, 2, 1}));
}

TEST(AttractorsAttractorCount, NothingOfNothing) {
  const Basins basins = tell_apart({});
  EXPECT_TRUE(basins.attractors.empty());
  EXPECT_TRUE(basins.numbers.empty());
}

}  // namespace
}  // namespace rubsweep::sweep
