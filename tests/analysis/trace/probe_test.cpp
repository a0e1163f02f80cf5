#include "rubsweep/analysis/trace/probe.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "rubsweep/analysis/trace/trace_run.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::trace {
namespace {

using test::OneSideRotor;

/// x and y of a Jeffcott rotor with one casing.
Probes probes(double sample_s, double noise_m = 0) {
  Probes both;
  both.rows = Eigen::MatrixXd::Zero(2, 4);
  both.rows(0, 0) = both.rows(1, 1) = 1;
  both.angle_deg = {0, 90};
  both.sample_s = sample_s;
  both.noise_m = noise_m;
  return both;
}

Trace run(const OneSideRotor& rotor, long revolutions, std::optional<Probes> probes, bool kicked = true) {
  scene::Scene scene = test::cell_of(rotor).scene;
  if (!kicked) scene.pulses.clear();
  integrate::exact::modes::ModeCache modes;
  const integrate::run::SolverOptions solver;
  return trace_run(integrate::start(scene, solver, modes).advance, scene, solver,
                   {.speed_hz = rotor.speed_hz,
                    .revolutions = revolutions,
                    .samples_per_revolution = 100,
                    .window_revolutions = 6,
                    .trajectory_revolutions = {},
                    .probes = std::move(probes)});
}

/// On the quiet whirl z = i A e^{i w t}, at instants that no grid of the turn has.
TEST(ProbeReader, ReadsTheQuietWhirlAtItsOwnInstants) {
  const OneSideRotor rotor;
  const double sample_s = 7.77e-4, whirl_m = rotor.whirl_ratio * rotor.clearance_m;
  const Trace trace = run(rotor, 9, probes(sample_s), false);
  // Readings before the end of the last turn, t = 0 among them.
  const auto count = static_cast<Eigen::Index>(std::ceil(9 / rotor.speed_hz / sample_s));
  ASSERT_EQ(trace.readings_m.rows(), count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const double angle = 2 * std::numbers::pi * rotor.speed_hz * sample_s * static_cast<double>(k);
    EXPECT_NEAR(trace.readings_m(k, 0), -whirl_m * std::sin(angle), 1e-15 + 1e-13 * whirl_m);
    EXPECT_NEAR(trace.readings_m(k, 1), whirl_m * std::cos(angle), 1e-15 + 1e-13 * whirl_m);
  }
}

/// Where a reading falls on a sample of the trajectory it is that sample, contact or not.
TEST(ProbeReader, AgreesWithTheTrajectoryThroughContacts) {
  const OneSideRotor rotor;
  const Trace trace = run(rotor, 12, probes(1 / (rotor.speed_hz * 25)));
  ASSERT_TRUE(trace.last_contact_revolution);
  ASSERT_EQ(trace.readings_m.rows(), 300);
  for (Eigen::Index k = 0; k < 300; ++k) {
    const auto& z = trace.trajectory[static_cast<std::size_t>(4 * k)].state.displacement_m;
    EXPECT_NEAR(trace.readings_m(k, 0), z.x(), 1e-12);
    EXPECT_NEAR(trace.readings_m(k, 1), z.y(), 1e-12);
  }
}

/// Looking by probes changes neither what is traced nor where.
TEST(ProbeReader, LeavesTheTraceAsItIs) {
  const OneSideRotor rotor;
  const Trace with = run(rotor, 5, probes(1e-3)), without = run(rotor, 5, std::nullopt);
  EXPECT_EQ(without.readings_m.size(), 0);
  ASSERT_EQ(with.trajectory.size(), without.trajectory.size());
  for (std::size_t k = 0; k < with.trajectory.size(); ++k) {
    EXPECT_EQ(with.trajectory[k].time_s, without.trajectory[k].time_s);
    EXPECT_LT((with.trajectory[k].state.displacement_m - without.trajectory[k].state.displacement_m).norm(),
              1e-14);
  }
}

TEST(ProbeReader, NoiseHasItsSizeAndIsTheSameInEveryRun) {
  const OneSideRotor rotor;
  const double noise_m = 2e-6;
  const Eigen::MatrixXd clean = run(rotor, 60, probes(1e-4), false).readings_m,
                        noisy = run(rotor, 60, probes(1e-4, noise_m), false).readings_m,
                        again = run(rotor, 60, probes(1e-4, noise_m), false).readings_m;
  EXPECT_EQ(noisy, again);
  const Eigen::MatrixXd noise = noisy - clean;
  const double deviation = noise.norm() / std::sqrt(static_cast<double>(noise.size()));
  EXPECT_NEAR(deviation, noise_m, 0.05 * noise_m);
  EXPECT_LT(std::abs(noise.mean()), 0.1 * noise_m);
}

}  // namespace
}  // namespace rubsweep::trace
