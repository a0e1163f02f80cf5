#include "rubsweep/core/model/speed_text.hpp"

#include <gtest/gtest.h>

namespace rubsweep::model {
namespace {

TEST(SpeedText, HasBothUnits) {
  EXPECT_EQ(speed_text(75), "75 Hz (4500 rpm)");
  EXPECT_EQ(speed_text(0), "0 Hz (0 rpm)");
  EXPECT_EQ(speed_range_text(50, 150), "50 to 150 Hz (3000 to 9000 rpm)");
}

TEST(SpeedText, RoundsEachNumberToTheSameDigits) {
  EXPECT_EQ(speed_text(51.666666666666664), "51.6667 Hz (3100 rpm)");
  EXPECT_EQ(speed_text(43.3219, 4), "43.32 Hz (2599 rpm)");
  EXPECT_EQ(speed_range_text(33.456789, 44.1, 3), "33.5 to 44.1 Hz (2010 to 2650 rpm)");
}

}  // namespace
}  // namespace rubsweep::model
