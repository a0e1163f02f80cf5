#include "rubsweep/scope/order_history.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rubsweep/error.hpp"

namespace rubsweep::scope {
namespace {

using recording::samples_per_revolution;
using std::numbers::pi;

/// Turns of f + r t revolutions a second with x = Re(A e^{i phi}) and y = Re(B e^{i phi / 2}), about a gap.
recording::Recording motion(double f, double r) {
  recording::Recording recording{.sampling_rate_hz = 5000, .plane = true};
  for (int n = 0; n <= 100; ++n) recording.turn_begin_s.push_back(2 * n / (f + std::sqrt(f * f + 2 * r * n)));
  for (int k = 0; k < 100 * samples_per_revolution; ++k) {
    const double phi = 2 * pi * k / samples_per_revolution;
    recording.displacement_m.emplace_back(1e-3 + 3e-5 * std::cos(phi - pi / 3),
                                          2e-5 * std::cos(phi / 2 + pi / 6));
  }
  return recording;
}

TEST(OrderHistory, ComponentsAreThoseThatWerePutIn) {
  const auto recording = motion(50, 4);
  for (const OrderPoint& point : order_history(recording, 1)) {
    EXPECT_NEAR(std::abs(point.x_m), 3e-5, 1e-9);
    EXPECT_NEAR(std::arg(point.x_m), -pi / 3, 1e-4);
    EXPECT_NEAR(point.speed_hz, 50 + 4 * point.t_s, 0.01);
  }
  for (const OrderPoint& point : order_history(recording, 0.5)) {
    EXPECT_NEAR(std::abs(point.y_m), 2e-5, 1e-9);
    EXPECT_NEAR(std::arg(point.y_m), pi / 6, 1e-4);
  }
  EXPECT_EQ(order_history(recording, 1).size(), 99u);
  EXPECT_EQ(order_history(recording, 0.375).size(), 93u);
  EXPECT_THROW(order_history(recording, 0.3), SolverError);
}

TEST(OrderHistory, TellsAChangingSpeed) {
  EXPECT_FALSE(speed_changes(motion(50, 0)));
  EXPECT_FALSE(speed_changes(motion(50, 0.2)));
  EXPECT_TRUE(speed_changes(motion(50, 4)));
}

TEST(OrderHistory, Tables) {
  const auto recording = motion(50, 4);
  const std::string bode = bode_csv(recording, {1, 2});
  EXPECT_TRUE(bode.starts_with("t_s,speed_hz,order,x_amplitude_m,x_phase_deg,y_amplitude_m,y_phase_deg\n"));
  EXPECT_EQ(std::ranges::count(bode, '\n'), 1 + 2 * 99);
  EXPECT_EQ(std::ranges::count(waterfall_csv(recording), '\n'), 1 + 12 * 128);
}

}  // namespace
}  // namespace rubsweep::scope
