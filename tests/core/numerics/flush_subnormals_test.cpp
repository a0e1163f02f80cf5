#include "rubsweep/core/numerics/flush_subnormals.hpp"

#include <gtest/gtest.h>

#include <limits>

#if defined(__SSE2__)  // on other processors they do nothing
namespace rubsweep::numerics {
namespace {

double half_of_smallest_normal() {
  volatile double smallest = std::numeric_limits<double>::min();
  return 0.5 * smallest;
}

/// Value after `steps` steps from 1, each of which reduces it by a tenth.
double after_decay(int steps) {
  volatile double left = 1;
  for (int k = 0; k < steps; ++k) left = 0.9 * left;
  return left;
}

TEST(FlushSubnormals, EndWithTheScope) {
  ASSERT_GT(half_of_smallest_normal(), 0);
  {
    const FlushSubnormals flush;
    EXPECT_EQ(half_of_smallest_normal(), 0);
    {
      const FlushSubnormals again;
      EXPECT_EQ(half_of_smallest_normal(), 0);
    }
    EXPECT_EQ(half_of_smallest_normal(), 0);
  }
  EXPECT_GT(half_of_smallest_normal(), 0);
}

TEST(FlushSubnormals, AVibrationThatDiesOutComesToZero) {
  EXPECT_GT(after_decay(10'000), 0) << "rounding keeps the smallest number alive";
  const FlushSubnormals flush;
  EXPECT_EQ(after_decay(10'000), 0);
}

TEST(FlushSubnormals, LeaveNormalNumbersAsTheyAre) {
  volatile double number = 1e-300;
  const double before = 1.1 * number;
  const FlushSubnormals flush;
  EXPECT_EQ(1.1 * number, before);
}

}  // namespace
}  // namespace rubsweep::numerics
#endif
