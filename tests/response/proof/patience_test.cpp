#include "rubsweep/response/proof/patience.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rubsweep::response::proof {
namespace {

TEST(Patience, IsThreeTimesWhatIsPromisedBehindAStart) {
  const Patience patience{.start = 10, .most = 100};
  EXPECT_EQ(patience.turns(0), 10);
  EXPECT_EQ(patience.turns(7), 31);
  EXPECT_EQ(patience.turns(1000), 100);
}

TEST(Patience, IsWorthWhatTheTransientHasGained) {
  const Patience patience{.start = 10, .most = 100};
  EXPECT_NEAR(patience.turns(0.9, 1, std::pow(0.9, 7)), 31, 1e-9);
  EXPECT_EQ(patience.turns(0.9, 1, 1), 10);
  EXPECT_EQ(patience.turns(0.9, 1, 2), 10);
  EXPECT_EQ(patience.turns(0.9, 1, 0), 100);
}

}  // namespace
}  // namespace rubsweep::response::proof
