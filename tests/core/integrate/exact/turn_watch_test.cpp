#include "rubsweep/core/integrate/exact/turn_watch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include "support/simple_scenes.hpp"

namespace rubsweep::integrate::exact {
namespace {

/// An undamped mass on a spring with three vibrations per turn, released at a distance of 1 from rest.
struct Vibration {
  static constexpr double period_s = 6 * std::numbers::pi;

  Vibration()
      : scene(of_three_vibrations()),
        modes(std::make_shared<modes::MachineModes<2>>(scene)),
        motion(scene, modes),
        watch(*modes, scene, period_s) {
    ExactMotion<2>::State start = ExactMotion<2>::State::Zero();
    start(0) = 1;
    motion.set_phases(0);
    EXPECT_TRUE(motion.enter(0, start));
  }

  static scene::Scene of_three_vibrations() {
    scene::Scene scene = test::one_mass_scene(1, 1, 0, period_s, 1);
    scene.contacts.push_back(test::wall_across_x(1, 10, 100, 0));
    return scene;
  }

  /// Runs one turn in steps of `size_s`.
  run::TurnReport turn(const run::TurnRequest& request, double size_s) {
    run::TurnReport report;
    report.clear();
    watch.begin_turn(request, report, 4);
    watch.begin_motion(motion);
    for (double time_s = 0; time_s < period_s;) {
      watch.start_step(motion, time_s, report);
      const double step_s = std::min(size_s, period_s - time_s);
      motion.step_by(step_s);
      time_s += step_s;
      watch.end_step(motion, time_s, step_s, report);
    }
    return report;
  }

  scene::Scene scene;
  std::shared_ptr<modes::MachineModes<2>> modes;
  ExactMotion<2> motion;
  TurnWatch<2> watch;
};

TEST(TurnWatch, TakesSamplesThatStepsDoNotEndAt) {
  Vibration vibration;
  constexpr int samples = 50;
  const run::TurnReport report = vibration.turn({.samples_per_revolution = samples}, 0.41);
  ASSERT_EQ(report.sample_count, samples);
  EXPECT_EQ(report.peak_displacement_m, 0);
  for (int k = 0; k < samples; ++k) {
    const double angle = Vibration::period_s * k / samples;
    EXPECT_NEAR(report.samples[static_cast<std::size_t>(4 * k)], std::cos(angle), 1e-13) << k;
    // Velocities are per radian of the shaft angle; one second is 1/3 radian.
    EXPECT_NEAR(report.samples[static_cast<std::size_t>(4 * k + 2)], -3 * std::sin(angle), 1e-12) << k;
  }
}

TEST(TurnWatch, FindsThePeakWithAndWithoutSamples) {
  for (const int samples : {0, 64}) {
    Vibration vibration;
    const run::TurnReport report =
        vibration.turn({.samples_per_revolution = samples, .peaks = true}, Vibration::period_s / 64);
    EXPECT_NEAR(report.peak_displacement_m, 1, 1e-5) << samples;
  }
}

/// Only peaks require short steps; between the ends of these steps there are no samples.
TEST(TurnWatch, ShortensStepsForPeaksAlone) {
  Vibration vibration;
  run::TurnReport report;
  vibration.watch.begin_turn({}, report, 4);
  EXPECT_FALSE(vibration.watch.wanted());
  EXPECT_EQ(vibration.watch.longest_step_s(vibration.motion), std::numeric_limits<double>::infinity());
  vibration.watch.begin_turn({.peaks = true}, report, 4);
  EXPECT_TRUE(vibration.watch.wanted());
  EXPECT_EQ(vibration.watch.longest_step_s(vibration.motion), Vibration::period_s / 64);
  vibration.watch.begin_turn({.samples_per_revolution = 8, .peaks = true}, report, 4);
  EXPECT_EQ(vibration.watch.longest_step_s(vibration.motion), Vibration::period_s);
  EXPECT_EQ(vibration.watch.boundary_s(vibration.motion), Vibration::period_s);
  EXPECT_EQ(vibration.watch.reach_s(vibration.motion), vibration.motion.reach_s());
}

}  // namespace
}  // namespace rubsweep::integrate::exact
