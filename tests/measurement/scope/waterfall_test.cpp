#include "rubsweep/measurement/scope/waterfall.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <initializer_list>
#include <numbers>
#include <sstream>
#include <string>
#include <utility>

#include "rubsweep/core/error.hpp"

namespace rubsweep::scope {
namespace {

using recording::samples_per_revolution;
using std::numbers::pi;

/// Turns at the speed f + r t, in Hz, with x = Re(A e^{i phi}) and y = Re(B e^{i phi / 2}) about a gap.
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

TEST(Waterfall, ComponentsAreThoseThatWerePutIn) {
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
  EXPECT_EQ(order_history(recording, 0.375).size(), 85u);
  EXPECT_THROW(order_history(recording, 0.3), SolverError);
}

TEST(Waterfall, AResonanceOf1XIsNotSeenIn2X) {
  auto recording = motion(50, 4);
  for (std::size_t k = 0; k < recording.displacement_m.size(); ++k) {
    const double turn = static_cast<double>(k) / samples_per_revolution;
    recording.displacement_m[k] = std::polar(1e-4 / (1 + std::pow((turn - 45) / 4, 2)), 2 * pi * turn) +
                                  std::polar(2e-7, 4 * pi * turn);
  }
  for (const OrderPoint& point : order_history(recording, 2)) EXPECT_NEAR(std::abs(point.x_m), 2e-7, 1e-7);
}

TEST(Waterfall, TellsAChangingSpeed) {
  EXPECT_FALSE(speed_changes(motion(50, 0)));
  EXPECT_FALSE(speed_changes(motion(50, 0.2)));
  EXPECT_TRUE(speed_changes(motion(50, 4)));
}

TEST(Waterfall, Tables) {
  const auto recording = motion(50, 4);
  const std::string bode = bode_csv(recording, {1, 2});
  EXPECT_TRUE(bode.starts_with("t_s,speed_hz,order,x_amplitude_m,x_phase_deg,y_amplitude_m,y_phase_deg\n"));
  EXPECT_EQ(std::ranges::count(bode, '\n'), 1 + 99 + 97);
  EXPECT_EQ(std::ranges::count(waterfall_csv(recording), '\n'), 1 + 11 * 256);
}

TEST(Waterfall, ABodePlotWithoutAMarkHasNoPhases) {
  auto recording = motion(50, 4);
  recording.phased = false;
  std::istringstream lines(bode_csv(recording, {1}));
  std::string line;
  std::getline(lines, line);
  int rows = 0;
  for (; std::getline(lines, line); ++rows) {
    double t_s = 0, speed_hz = 0, order = 0, x_m = 0, y_m = 0;
    char end = 0;
    ASSERT_EQ(std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf,,%lf%c", &t_s, &speed_hz, &order, &x_m, &y_m, &end),
              6)
        << line;
    EXPECT_EQ(end, ',');
    EXPECT_NEAR(x_m, 3e-5, 1e-9);
  }
  EXPECT_EQ(rows, 99);
}

/// Largest amplitude in the waterfall at orders farther than `aside` from all `orders`, and the largest
/// amplitude overall.
std::pair<double, double> beside_and_at(const std::string& waterfall, std::initializer_list<double> orders,
                                        double aside) {
  std::istringstream lines(waterfall);
  std::string line;
  std::getline(lines, line);
  double beside = 0, largest = 0, t_s = 0, speed_hz = 0, order = 0, amplitude_m = 0;
  while (std::getline(lines, line)) {
    if (std::sscanf(line.c_str(), "%lf,%lf,%lf,%lf", &t_s, &speed_hz, &order, &amplitude_m) != 4)
      ADD_FAILURE();
    largest = std::fmax(largest, amplitude_m);
    if (std::ranges::all_of(orders, [&](double one) { return std::abs(order - one) > aside; }))
      beside = std::fmax(beside, amplitude_m);
  }
  return {beside, largest};
}

TEST(Waterfall, AResonanceStaysAtItsOrdersInAWaterfall) {
  // A vibration at 3.3X that grows and decays within a few turns, with forward 1X and a drifting gap (0X).
  auto recording = motion(50, 4);
  for (std::size_t k = 0; k < recording.displacement_m.size(); ++k) {
    const double turn = static_cast<double>(k) / samples_per_revolution;
    const double swell = 1e-4 / (1 + std::pow((turn - 45) / 6, 2));
    recording.displacement_m[k] =
        1e-3 + 1e-7 * turn + std::polar(3e-5, 2 * pi * turn) + std::polar(swell, 2 * pi * 3.3 * turn);
  }
  const auto [beside, largest] = beside_and_at(waterfall_csv(recording), {0, 1, 3.3}, 0.5);
  EXPECT_GT(largest, 7e-5);
  EXPECT_LT(largest, 1e-4);
  EXPECT_LT(beside, 1e-3 * largest);
}

TEST(Waterfall, ASteadyLineOfAWaterfallStandsAloneWithItsAmplitude) {
  auto recording = motion(50, 0);
  for (std::size_t k = 0; k < recording.displacement_m.size(); ++k)
    recording.displacement_m[k] =
        std::polar(2e-5, -2 * pi * 0.375 * static_cast<double>(k) / samples_per_revolution);
  const auto [beside, largest] = beside_and_at(waterfall_csv(recording), {-0.375}, 0.1);
  EXPECT_NEAR(largest, 2e-5, 1e-10);
  EXPECT_LT(beside, 1e-10);
}

TEST(Waterfall, AFewTurnsHaveAWaterfallOfOneSpectrumOrNone) {
  for (const auto& [turns, lines] : {std::pair{7, 0}, {8, 128}, {15, 128}, {16, 256}, {24, 2 * 256}}) {
    auto recording = motion(50, 0);
    recording.turn_begin_s.resize(static_cast<std::size_t>(turns) + 1);
    recording.displacement_m.resize(static_cast<std::size_t>(turns) * samples_per_revolution);
    EXPECT_EQ(std::ranges::count(waterfall_csv(recording), '\n'), 1 + lines) << turns;
  }
}

}  // namespace
}  // namespace rubsweep::scope
