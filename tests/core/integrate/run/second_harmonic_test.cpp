#include "rubsweep/core/integrate/run/second_harmonic.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "rubsweep/core/integrate/run/pulse_times.hpp"
#include "rubsweep/core/integrate/run/scaled_system.hpp"
#include "support/simple_scenes.hpp"

namespace rubsweep::integrate::run {
namespace {

using std::numbers::pi;

scene::Scene scene_with_harmonic(const Eigen::VectorXcd& second_n) {
  scene::Scene scene = test::one_mass_scene(2, 800, 3, 0.31, 1e-3);
  scene.second_harmonic_n = second_n;
  return scene;
}

const Eigen::Vector2cd second_n{std::complex<double>(3, -2), std::complex<double>(-0.5, 1)};

TEST(SecondHarmonic, ItsPartsAddUpToTheForce) {
  EXPECT_TRUE(second_harmonic(scene_with_harmonic({})).empty());
  for (const double turns : {0.0, 0.13, 0.6, 0.99}) {
    Eigen::Vector2d sum(0, 0);
    for (const HarmonicPart& part : second_harmonic(scene_with_harmonic(second_n)))
      sum += part.top_n * std::sin(4 * pi * (turns + part.turns_ahead));
    EXPECT_LT((sum - (second_n * std::polar(1.0, 4 * pi * turns)).real()).norm(), 1e-14);
  }
}

/// The second harmonic follows the scene's pulses, acts from the start without end, and has the same phase in
/// every revolution.
TEST(SecondHarmonic, ItActsAlways) {
  scene::Scene scene = scene_with_harmonic(second_n);
  scene.pulses.push_back({Eigen::Vector2d(1, 0), 5, 0.1 * scene.period_s()});
  PulseTimes times(scene, state_scale(scene), 2 * pi);
  EXPECT_EQ(times.acting(), (std::vector<std::size_t>{1, 2}));
  EXPECT_TRUE(times.begin_turn(0));
  EXPECT_EQ(times.acting(), (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_TRUE(times.go_to(times.next_change()));
  EXPECT_EQ(times.acting(), (std::vector<std::size_t>{1, 2}));
  for (const long revolution : {1L, 7L, 100'000'000L}) {
    EXPECT_FALSE(times.begin_turn(revolution));
    EXPECT_DOUBLE_EQ(times.angle_rad(1, 0.3), 2 * (0.3 + pi / 4));
    EXPECT_DOUBLE_EQ(times.angle_rad(2, 0.3), 2 * 0.3);
  }
}

TEST(SecondHarmonic, TheScaledSystemHasItInItsUnits) {
  const scene::Scene scene = scene_with_harmonic(second_n);
  const ScaledSystem<2> system = scale<2>(scene);
  ASSERT_EQ(system.pulses.size(), 2U);
  Eigen::Vector2d sum(0, 0);
  const double phase = 1.3;
  for (const auto& pulse : system.pulses)
    sum += pulse.top * std::sin(pulse.rate * (*pulse.always_elapsed + phase));
  const Eigen::Vector2d acceleration = (second_n * std::polar(1.0, 2 * phase)).real() / 2;
  EXPECT_LT((sum * system.scale.unit_acceleration_m_per_s2() - acceleration).norm(), 1e-13);
}

}  // namespace
}  // namespace rubsweep::integrate::run
