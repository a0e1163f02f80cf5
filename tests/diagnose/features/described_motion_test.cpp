#include "rubsweep/diagnose/features/described_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "turned_lines.hpp"

namespace rubsweep::diagnose::features {
namespace {

using std::numbers::pi;

TEST(DescribedMotion, HasTheSameFeaturesHoweverItIsTurnedScaledAndMarked) {
  response::spectrum::SpectrumWorkspace workspace;
  const MotionLines lines = crooked_motion();
  const DescribedMotion one = describe(lines, {}, workspace);
  // Marks an eighth of a turn apart: the samples of the waveform are the same then, but begin elsewhere.
  const DescribedMotion other = describe(seen_otherwise(lines, 3e-5, 1.1, 2 * pi * 9 / 8), {}, workspace);
  ASSERT_EQ(one.features.size(), other.features.size());
  for (std::size_t i = 0; i < one.features.size(); ++i) {
    EXPECT_EQ(one.features[i].name, other.features[i].name);
    EXPECT_NEAR(one.features[i].value, other.features[i].value, 1e-6) << one.features[i].name;
  }
  EXPECT_NEAR(other.size_m / one.size_m, 3e-5, 1e-12);
  EXPECT_NEAR(std::remainder(other.direction_rad - one.direction_rad - 1.1, 2 * pi), 0, 1e-6);
}

TEST(DescribedMotion, OfOneProbeHasTheSameFeaturesHoweverItIsScaledAndMarked) {
  response::spectrum::SpectrumWorkspace workspace;
  const MotionLines lines = crooked_motion();
  const DescribedMotion one = describe(one_reading(lines), {.plane = false}, workspace),
                        other = describe(one_reading(seen_otherwise(lines, 2, 0, 2 * pi * 5 / 8)), {.plane = false},
                                         workspace);
  for (std::size_t i = 0; i < one.features.size(); ++i)
    EXPECT_NEAR(one.features[i].value, other.features[i].value, 1e-6) << one.features[i].name;
  EXPECT_EQ(one.direction_rad, 0);
}

TEST(DescribedMotion, NamesItsFeaturesOnce) {
  response::spectrum::SpectrumWorkspace workspace;
  for (const bool plane : {true, false}) {
    std::set<std::string> names;
    const DescribedMotion motion =
        describe(plane ? crooked_motion() : one_reading(crooked_motion()), {.plane = plane}, workspace);
    for (const Feature& feature : motion.features) {
      EXPECT_TRUE(std::isfinite(feature.value)) << feature.name;
      names.insert(feature.name);
    }
    EXPECT_EQ(names.size(), motion.features.size());
    EXPECT_EQ(values_of(motion.features).size(), static_cast<Eigen::Index>(motion.features.size()));
  }
}

}  // namespace
}  // namespace rubsweep::diagnose::features
