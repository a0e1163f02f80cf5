#include "rubsweep/core/integrate/exact/drives.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "rubsweep/core/integrate/exact/modes/machine_modes.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::integrate::exact {
namespace {

constexpr double later_s = 7e-4, start_s = 1e-4;

/// A cell on which unbalance and kick both act.
struct Driven {
  scene::Scene scene = test::cell_of({}).scene;
  modes::MachineModes<4> modes{scene};
  Drives drives{scene, modes.inverse_mass(), modes.system()};
  Phasors phasors;

  Driven() {
    run::PulseTimes times(scene, run::state_scale(scene).in_seconds(), scene.period_s());
    times.begin_turn(0);
    drives.start(0.4, times, start_s, phasors);
  }

  /// Accelerations of all coordinates from the scene's forces, in scaled lengths per s^2.
  Eigen::VectorXd expected(double time_s) const {
    const double phase = 0.4 + scene.speed_rad_per_s * (time_s - start_s);
    Eigen::VectorXd force = (scene.harmonic_n * std::polar(1.0, phase)).real();
    for (const scene::Pulse& pulse : scene.pulses)
      force += pulse.force_n * std::sin(std::numbers::pi * time_s / pulse.duration_s) * pulse.direction;
    return modes.inverse_mass() * force / scene.length_scale_m;
  }
  Eigen::VectorXd seen() const {
    Eigen::VectorXd sum = Eigen::VectorXd::Zero(4);
    for (Eigen::Index j = 0; j < 4; ++j) drives.add_acceleration(j, phasors, sum(j));
    return sum;
  }
};

TEST(Drives, AccelerateAsTheSceneSays) {
  Driven driven;
  ASSERT_EQ(driven.drives.acting(), std::vector<std::size_t>{0});
  EXPECT_TRUE(driven.seen().isApprox(driven.expected(start_s), 1e-13));
  driven.drives.turn(driven.phasors, later_s - start_s);
  EXPECT_TRUE(driven.seen().isApprox(driven.expected(later_s), 1e-13));
  double closing = 0;
  driven.drives.add_closing(0, driven.phasors, closing);
  const double along = driven.modes.system().contacts[0].first_row.dot(driven.expected(later_s).transpose());
  EXPECT_NEAR(closing, along, 1e-12 * std::abs(along));
}

TEST(Drives, TurnByTurnsThatAreKept) {
  Driven at_once, kept;
  at_once.drives.turn(at_once.phasors, 2e-4);
  kept.drives.turn(kept.phasors, kept.drives.turns(2e-4));
  EXPECT_EQ(at_once.phasors.shaft, kept.phasors.shaft);
  EXPECT_EQ(at_once.phasors.pulses, kept.phasors.pulses);
}

TEST(Drives, WithoutPulsesTheShaftAloneCounts) {
  Driven driven;
  const double shaft = driven.scene.speed_rad_per_s,
               kick = std::numbers::pi / driven.scene.pulses[0].duration_s;
  EXPECT_EQ(driven.drives.fastest_rad_per_s(0), std::max(shaft, kick));
  EXPECT_EQ(driven.drives.fastest_rad_per_s(1e6), 1e6);
  driven.drives.start(1.2, driven.phasors);
  EXPECT_TRUE(driven.phasors.pulses.empty());
  EXPECT_EQ(driven.drives.fastest_rad_per_s(0), shaft);
}

}  // namespace
}  // namespace rubsweep::integrate::exact
