#include "rubsweep/maps/table/time_stamp.hpp"

#include <gtest/gtest.h>

namespace rubsweep::table {
namespace {

constexpr NumberStyle with_point{',', false}, with_comma{';', true};

TEST(TimeStampIn, CountsSeconds) {
  EXPECT_EQ(time_stamp_in("01:02:03.25", with_point), 3723.25);
  EXPECT_EQ(time_stamp_in("01:02:03,25", with_comma), 3723.25);
  EXPECT_EQ(time_stamp_in("1970-01-02T00:00:01Z", with_point), 86401);
  EXPECT_EQ(time_stamp_in("02.01.1970 00:00:01,5", with_comma), 86401.5);
  // 2024 is a leap year.
  EXPECT_EQ(time_stamp_in("2024-03-01 00:00:00", with_point).value() -
                time_stamp_in("2024-02-28 00:00:00", with_point).value(),
            2 * 86400);
  for (const char* wrong :
       {"", "12", "12:30", "24:00:00", "12:60:00", "2023-02-29 00:00:00", "a:b:c", "-1:00:00",
        "1:2:", ":::", "1/2 1:00:00", "2024-13-01 00:00:00", "99999999999-1-1 00:00:00"})
    EXPECT_FALSE(time_stamp_in(wrong, with_point)) << wrong;
}

TEST(TimeStampIn, KnowsTheHalvesOfADay) {
  EXPECT_EQ(time_stamp_in("12:00:01 AM", with_point), 1);
  EXPECT_EQ(time_stamp_in("12:00:01.5 pm", with_point), 43201.5);
  EXPECT_EQ(time_stamp_in("11:59:59PM", with_point), 86399);
  EXPECT_EQ(time_stamp_in("1/2/1970 1:00:00 p.m.", with_point), 86400 + 13 * 3600);
  for (const char* wrong : {"13:00:00 PM", "0:00:00 AM", "PM", "AM"})
    EXPECT_FALSE(time_stamp_in(wrong, with_point)) << wrong;
}

TEST(TimeStampIn, KnowsZonesAndOtherOrdersOfADate) {
  EXPECT_EQ(time_stamp_in("1970-01-01T01:00:00+01:00", with_point), 0);
  EXPECT_EQ(time_stamp_in("1969-12-31 23:30:00.5 -0030", with_point), 0.5);
  EXPECT_EQ(time_stamp_in("1970-01-01 00:00:07 UTC", with_point), 7);
  for (const char* no_zone : {"01:00:00+0175", "01:00:00+15:00", "01:00:00+1"})
    EXPECT_FALSE(time_stamp_in(no_zone, with_point)) << no_zone;
  EXPECT_EQ(time_stamp_in("1970/01/02 00:00:00", with_point), 86400);
  EXPECT_EQ(time_stamp_in("13/01/1970 00:00:00", with_point), 12 * 86400);
  EXPECT_EQ(time_stamp_in("1/13/1970 00:00:00", with_point), 12 * 86400);
  EXPECT_EQ(time_stamp_in("2-Jan-1970 00:00:00", with_point), 86400);
}

}  // namespace
}  // namespace rubsweep::table
