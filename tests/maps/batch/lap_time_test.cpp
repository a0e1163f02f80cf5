#include "rubsweep/maps/batch/lap_time.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace rubsweep::batch {
namespace {

using namespace std::chrono_literals;

TEST(LapTime, CountsFromTheLastTaskOfTheSameThread) {
  const LapTime time;
  std::this_thread::sleep_for(60ms);
  EXPECT_GE(time.lap_s(), 0.06);
  EXPECT_LT(time.lap_s(), 0.06);
  std::this_thread::sleep_for(20ms);
  EXPECT_GE(time.lap_s(), 0.02);
  double of_other_s = 0;
  std::thread([&] { of_other_s = time.lap_s(); }).join();
  EXPECT_GE(of_other_s, 0.08);  // begun when the time was
}

TEST(LapTime, ForgetsWhatWasBeforeIt) {
  const LapTime first;
  first.lap_s();
  std::this_thread::sleep_for(60ms);
  EXPECT_LT(LapTime().lap_s(), 0.06);
}

}  // namespace
}  // namespace rubsweep::batch
