#include "rubsweep/diagnose/inference/other_cause.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "rubsweep/diagnose/lasting_motion.hpp"

namespace rubsweep::diagnose::inference {
namespace {

TEST(OtherCause, VibratesAtOnceTheSpeedAndAtOthers) {
  response::spectrum::SpectrumWorkspace workspace;
  int free_orders = 0, multiples = 0;
  for (std::uint64_t k = 0; k < 200; ++k) {
    RandomStream random(1, k, 0);
    const MotionLines lines = vibration_of_another_cause(12, random, workspace);
    ASSERT_EQ(lines.last(), static_cast<int>(12 * most_order));
    EXPECT_GT(std::abs(lines.at(12)), 0.05);
    double between = 0;
    for (int j = -lines.last(); j <= lines.last(); ++j)
      if (j % 12 != 0) between += std::norm(lines.at(j));
    (between > 1e-4 ? free_orders : multiples) += 1;
  }
  // One to four components, half of them multiples of the speed.
  EXPECT_GT(free_orders, 80);
  EXPECT_GT(multiples, 40);
}

TEST(OtherCause, DependsOnItsRandomNumbersAlone) {
  response::spectrum::SpectrumWorkspace workspace;
  RandomStream one(1, 5, 0), again(1, 5, 0);
  EXPECT_EQ(vibration_of_another_cause(12, one, workspace).amplitude,
            vibration_of_another_cause(12, again, workspace).amplitude);
}

}  // namespace
}  // namespace rubsweep::diagnose::inference
