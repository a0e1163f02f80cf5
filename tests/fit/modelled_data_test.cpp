#include "rubsweep/fit/modelled_data.hpp"

#include <gtest/gtest.h>

namespace rubsweep::fit {
namespace {

/// 1X of two sensors at three speeds.
MeasuredData steady_data(bool run_out) {
  Steady steady{.speed_hz = {10, 20, 30}, .phasor_m = Eigen::MatrixXcd(3, 2)};
  for (int k = 0; k < 3; ++k)
    for (int sensor = 0; sensor < 2; ++sensor) steady.phasor_m(k, sensor) = {k + 10.0 * sensor, -1.0 - k};
  return {.name = "steady.csv", .data = steady, .run_out = run_out};
}

TEST(ModelledData, ComparesRealPartsAndThenImaginaryOnesSensorBySensor) {
  Eigen::VectorXd expected(12);
  expected << 0, 1, 2, 10, 11, 12, -1, -2, -3, -1, -2, -3;
  EXPECT_EQ(measured_of(steady_data(false)), expected);
}

TEST(ModelledData, CountsWhatIsFittedWithEveryStep) {
  EXPECT_EQ(eliminated_of(steady_data(false)), 0);
  EXPECT_EQ(eliminated_of(steady_data(true)), 4);
  // The scale of the kick, and an offset of each of three sensors.
  const MeasuredData ring{.name = "ring.csv",
                          .data = RingDown{.t_s = {0, 1}, .signal_m = Eigen::MatrixXd(2, 3)}};
  EXPECT_EQ(eliminated_of(ring), 4);
}

}  // namespace
}  // namespace rubsweep::fit
