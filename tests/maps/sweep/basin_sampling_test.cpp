#include "rubsweep/maps/sweep/basin_sampling.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "maps/sweep/one_side_study.hpp"
#include "rubsweep/maps/sweep/evaluate_cell.hpp"

namespace rubsweep::sweep {
namespace {

const BasinSampling box{4000, {{"a", 0, 1, false}, {"b", 10, 1000, true}}};

TEST(BasinSampling, DrawsEvenlyFromItsBox) {
  std::size_t left = 0, low = 0;
  for (std::size_t i = 0; i < box.samples; ++i) {
    const auto keys = draw(box, i);
    ASSERT_EQ(keys.size(), 2u);
    EXPECT_EQ(keys[1].key, "b");
    if (keys[0].value < 0.3) ++left;
    if (keys[1].value < 100) ++low;
    EXPECT_GE(keys[1].value, 10);
    EXPECT_LE(keys[1].value, 1000);
  }
  EXPECT_NEAR(static_cast<double>(left), 1200, 5);
  EXPECT_NEAR(static_cast<double>(low), 2000, 5);
}

TEST(BasinSampling, CountsWhatItsSamplesLeadTo) {
  const Basins basins = sample_basins(box, [](const std::vector<KeyValue>& keys) -> SampledMotion {
    const double x = keys[0].value;
    if (x < 0.1) return {"failed", true, false, false, {}};
    return {x < 0.3 ? "chaotic" : "non_contact", false, x < 0.3, false, {x}};
  });
  ASSERT_EQ(basins.attractors.size(), 2u);
  EXPECT_NEAR(basins.attractors[0].share, 0.7, 2e-3);
  EXPECT_EQ(basins.attractors[1].motion.name, "chaotic");
  EXPECT_NEAR(static_cast<double>(basins.failed), 400, 4);
}

/// Independent check: every sample is simulated as a cell of its own study.
TEST(BasinSampling, OfACellCountsItsOwnRuns) {
  Study study = one_side_study({75}, {0.4});
  study.basin = BasinSampling{24, {{"kick.force_n", 0, 300, false}}};
  study.with_keys = [plain = study](std::span<const KeyValue> keys) {
    Study varied = plain;
    varied.machine.kick->force_n = keys.front().value;
    return varied;
  };
  response::motion::Workspace workspace;
  const Row row = evaluate_cell(study, 0, workspace);
  ASSERT_TRUE(row.basins);
  std::map<std::string, std::size_t> counts, counted;
  for (std::size_t i = 0; i < 24; ++i) {
    Study own = one_side_study({75}, {0.4});
    own.machine.kick->force_n = draw(*study.basin, i).front().value;
    ++counts[class_and_order(evaluate_cell(own, 0, workspace))];
  }
  for (const Attractor& attractor : row.basins->attractors)
    counted[attractor.motion.name] += attractor.samples;
  EXPECT_EQ(counted, counts);
  EXPECT_GE(counts.size(), 2u);
}

SampledMotion orbit(double length_m, double backward_m = 0.1) {
  return {"subharmonic 1/2", false, true, true, {length_m, 1, backward_m}};
}

Basins tell_apart(const std::vector<SampledMotion>& motions) {
  AttractorCount count;
  for (const SampledMotion& motion : motions) count.add(motion);
  return count.basins();
}

TEST(BasinSamplingAttractorCount, CountsOrbitsFailedStartsAndWhatNeverRepeats) {
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

TEST(BasinSamplingAttractorCount, ByAThousandthOfTheLargestLength) {
  EXPECT_EQ(tell_apart({orbit(2), orbit(2.0019)}).attractors.size(), 1u);
  EXPECT_EQ(tell_apart({orbit(2), orbit(2.0021)}).attractors.size(), 2u);
  EXPECT_EQ(tell_apart({orbit(2, 0.1), orbit(2, 0.1019)}).attractors.size(), 1u);
  EXPECT_EQ(tell_apart({orbit(2, 0.1), orbit(2, 0.1021)}).attractors.size(), 2u);
}

TEST(BasinSamplingAttractorCount, EquallyFrequentOnesInTheOrderInWhichTheyAreMet) {
  EXPECT_EQ(tell_apart({orbit(5), orbit(4), orbit(4), orbit(5)}).numbers, (std::vector<int>{1, 2, 2, 1}));
}

TEST(BasinSamplingAttractorCount, NothingOfNothing) {
  const Basins basins = tell_apart({});
  EXPECT_TRUE(basins.attractors.empty());
  EXPECT_TRUE(basins.numbers.empty());
}

}  // namespace
}  // namespace rubsweep::sweep
