#include "rubsweep/response/aperiodic.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace rubsweep::response {
namespace {

constexpr int window = 64;

/// Follows a map whose observed x is the first of its coordinates. `contact_ends`: turns after which there is
/// none.
Aperiodic follow(const SectionMap& map, const std::vector<double>& state, int contact_ends = 1'000'000) {
  Eigen::Matrix<double, 2, Eigen::Dynamic> observed;
  observed.setZero(2, static_cast<Eigen::Index>(state.size() / 2));
  observed(0, 0) = 1;
  int turns = 0;
  SpectrumWorkspace workspace;
  return classify_aperiodic(
      map, [&] { return ++turns <= contact_ends; }, state, observed, window, workspace);
}

std::string name(const Aperiodic& found) { return std::string(to_string(found.motion_class)); }

bool henon(std::span<double> s) {
  const double x = s[0];
  s[0] = 1 - 1.4 * x * x + s[1];
  s[1] = 0.3 * x;
  return true;
}

/// Turns by `angle` and is drawn to the unit circle; `stretch` < 1 makes the turning uneven.
SectionMap circle(double angle, double stretch) {
  return [=](std::span<double> s) {
    const double phi = std::atan2(s[1], s[0]), radius = std::hypot(s[0], s[1]);
    const double next = phi + angle + stretch * std::sin(phi);
    s[0] = (1 + 0.5 * (radius - 1)) * std::cos(next);
    s[1] = (1 + 0.5 * (radius - 1)) * std::sin(next);
    return true;
  };
}

/// A strongly attracting motion of period two, and beside it a modulation that turns and grows at `rate`.
SectionMap modulated_period_two(double rate) {
  return [=](std::span<double> s) {
    s[0] = -s[0] * (1.5 - 0.5 * s[0] * s[0]);
    const double u = s[1], v = s[2], grow = std::exp(rate);
    s[1] = grow * (u * std::cos(1.0) - v * std::sin(1.0));
    s[2] = grow * (u * std::sin(1.0) + v * std::cos(1.0));
    s[3] *= 0.1;
    return true;
  };
}

TEST(ClassifyAperiodic, HenonsMapIsChaotic) {
  const Aperiodic found = follow(henon, {0.1, 0.2});
  EXPECT_EQ(name(found), "chaotic");
  EXPECT_NEAR(found.exponent.value().per_revolution, 0.41922, found.exponent->error_bar);
  EXPECT_FALSE(found.returns_after);
}

TEST(ClassifyAperiodic, ATorusIsQuasiPeriodic) {
  for (const double stretch : {0.0, 0.5, 0.9}) {
    const Aperiodic found = follow(circle(2 * std::numbers::pi * 0.381966, stretch), {0.6, 0.9});
    EXPECT_EQ(name(found), "quasi_periodic") << stretch;
    EXPECT_NEAR(found.exponent.value().per_revolution, 0, 1e-3);
  }
  EXPECT_EQ(name(follow(modulated_period_two(0), {0.9, 0.05, 0, 0.1})), "quasi_periodic");
}

TEST(ClassifyAperiodic, AModulationThatStillDecaysIsUnsettled) {
  // Its exponent is as good as zero, its lines stay: only the closest return tells.
  const Aperiodic found = follow(modulated_period_two(-4e-4), {0.9, 0.05, 0, 0.1});
  EXPECT_EQ(name(found), "unsettled");
  EXPECT_NEAR(found.exponent.value().per_revolution, -4e-4, 1e-6);
  EXPECT_FALSE(found.returns_after);
}

TEST(ClassifyAperiodic, ASlowDepartureIsNeitherChaosNorATorus) {
  const Aperiodic found = follow(modulated_period_two(8e-4), {0.9, 0.005, 0, 0.1});
  EXPECT_EQ(name(found), "unsettled");
  EXPECT_GT(found.exponent.value().per_revolution, found.exponent->error_bar);
}

TEST(ClassifyAperiodic, ADecayThatIsAlmostOverIsUnsettledAtTheFirstLook) {
  int calls = 0;
  const auto map = [&calls, decay = modulated_period_two(-0.02)](std::span<double> s) {
    ++calls;
    return decay(s);
  };
  const Aperiodic found = follow(map, {0.9, 0.5, 0, 0.1});
  EXPECT_EQ(name(found), "unsettled");
  EXPECT_NEAR(found.exponent.value().per_revolution, -0.02, 1e-4);
  EXPECT_EQ(calls, 2 * 640);
}

TEST(ClassifyAperiodic, ALongPeriodIsUnsettledAndNamed) {
  for (const int period : {14, 54, 127}) {
    const Aperiodic found = follow(circle(2 * std::numbers::pi / period, 0), {1, 0});
    EXPECT_EQ(name(found), "unsettled");
    EXPECT_EQ(found.returns_after, period);
  }
}

TEST(ClassifyAperiodic, ChaosThatEndsInAPeriodIsNotChaos) {
  // Both companion and base count, so 700 turns of chaos are 1400 calls.
  int calls = 0;
  const SectionMap map = [&calls](std::span<double> s) {
    if (++calls <= 1400) return henon(s);
    for (double& x : s) x *= 0.5;
    return true;
  };
  const Aperiodic found = follow(map, {0.1, 0.2});
  EXPECT_EQ(name(found), "unsettled");
  EXPECT_EQ(found.returns_after, 1);
}

TEST(ClassifyAperiodic, ChaosThatLosesContactIsNotChaos) {
  const Aperiodic found = follow(henon, {0.1, 0.2}, 300);
  EXPECT_EQ(name(found), "unsettled");
  EXPECT_FALSE(found.exponent);
  EXPECT_EQ(name(follow(henon, {0.1, 0.2}, 1280)), "chaotic");
}

TEST(ClassifyAperiodic, AShorterPauseIsContact) {
  int turns = 0;
  Eigen::Matrix<double, 2, Eigen::Dynamic> observed(2, 1);
  observed << 1, 0;
  SpectrumWorkspace workspace;
  const auto now_and_then = [&turns] { return ++turns % window == 0; };
  EXPECT_EQ(name(classify_aperiodic(henon, now_and_then, {0.1, 0.2}, observed, window, workspace)),
            "chaotic");
}

TEST(ClassifyAperiodic, AMapThatFailsLeavesNoExponent) {
  int calls = 0;
  const SectionMap map = [&calls](std::span<double> s) { return ++calls < 500 && henon(s); };
  const Aperiodic found = follow(map, {0.1, 0.2});
  EXPECT_EQ(name(found), "unsettled");
  EXPECT_FALSE(found.exponent);
}

TEST(ClassifyAperiodic, BroadLinesAreNoTorus) {
  // Steps of a random walk along the circle, the same for every state: exponent zero, no lines.
  unsigned long bits = 1;
  int calls = 0;
  double step = 0;
  const SectionMap map = [&](std::span<double> s) {
    if (++calls % 2 == 1) {
      bits = bits * 6364136223846793005UL + 1442695040888963407UL;
      step = 2 * std::numbers::pi * static_cast<double>(bits >> 11) * 0x1p-53;
    }
    return circle(step, 0)(s);
  };
  const Aperiodic found = follow(map, {1, 0});
  EXPECT_NEAR(found.exponent.value().per_revolution, 0, 1e-6);
  EXPECT_EQ(name(found), "unsettled");
}

}  // namespace
}  // namespace rubsweep::response
