#include "rubsweep/analysis/trace/probe.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "rubsweep/analysis/trace/trace_run.hpp"
#include "rubsweep/core/integrate/start.hpp"
#include "support/set_a_cell.hpp"

namespace rubsweep::trace {
namespace {

using test::OneSideRotor;

/// Probes in x and y for a Jeffcott rotor with one casing.
Probes probes(double sample_s, double noise_m = 0) {
  Probes both;
  both.rows = Eigen::MatrixXd::Zero(2, 4);
  both.rows(0, 0) = both.rows(1, 1) = 1;
  both.angle_deg = {0, 90};
  both.sample_s = sample_s;
  both.noise = {noise_m, noise_m};
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

/// The quiet whirl z = i A e^{i w t}, read at instants between all grid points of a turn.
TEST(ProbeReader, ReadsTheQuietWhirlAtItsOwnInstants) {
  const OneSideRotor rotor;
  const double sample_s = 7.77e-4, whirl_m = rotor.whirl_ratio * rotor.clearance_m;
  const Trace trace = run(rotor, 9, probes(sample_s), false);
  // Readings from t = 0 to the end of the last turn.
  const auto count = static_cast<Eigen::Index>(std::ceil(9 / rotor.speed_hz / sample_s));
  ASSERT_EQ(trace.readings.rows(), count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const double angle = 2 * std::numbers::pi * rotor.speed_hz * sample_s * static_cast<double>(k);
    EXPECT_NEAR(trace.readings(k, 0), -whirl_m * std::sin(angle), 1e-15 + 1e-13 * whirl_m);
    EXPECT_NEAR(trace.readings(k, 1), whirl_m * std::cos(angle), 1e-15 + 1e-13 * whirl_m);
  }
}

/// A reading at the instant of a trajectory sample equals this sample, with and without contact.
TEST(ProbeReader, AgreesWithTheTrajectoryThroughContacts) {
  const OneSideRotor rotor;
  const Trace trace = run(rotor, 12, probes(1 / (rotor.speed_hz * 25)));
  ASSERT_TRUE(trace.last_contact_revolution);
  ASSERT_EQ(trace.readings.rows(), 300);
  for (Eigen::Index k = 0; k < 300; ++k) {
    const auto& z = trace.trajectory[static_cast<std::size_t>(4 * k)].state.displacement_m;
    EXPECT_NEAR(trace.readings(k, 0), z.x(), 1e-12);
    EXPECT_NEAR(trace.readings(k, 1), z.y(), 1e-12);
  }
}

/// Reading the probes changes neither the trace nor its instants.
TEST(ProbeReader, LeavesTheTraceAsItIs) {
  const OneSideRotor rotor;
  const Trace with = run(rotor, 5, probes(1e-3)), without = run(rotor, 5, std::nullopt);
  EXPECT_EQ(without.readings.size(), 0);
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
  const Eigen::MatrixXd clean = run(rotor, 60, probes(1e-4), false).readings,
                        noisy = run(rotor, 60, probes(1e-4, noise_m), false).readings,
                        again = run(rotor, 60, probes(1e-4, noise_m), false).readings;
  EXPECT_EQ(noisy, again);
  const Eigen::MatrixXd noise = noisy - clean;
  const double deviation = noise.norm() / std::sqrt(static_cast<double>(noise.size()));
  EXPECT_NEAR(deviation, noise_m, 0.05 * noise_m);
  EXPECT_LT(std::abs(noise.mean()), 0.1 * noise_m);
}

/// Probes on the casing, coordinates 2 and 3: displacement, velocity and acceleration in one direction.
Probes casing_probes(Eigen::Index coordinate, double sample_s) {
  Probes all{.rows = Eigen::MatrixXd::Zero(3, 4), .angle_deg = {0, 0, 0}, .sample_s = sample_s};
  all.rows.col(coordinate).setOnes();
  all.derivative = {0, 1, 2};
  return all;
}

/// A casing that swings across its wall touches nothing: x = a cos(w t), v = -w a sin(w t), -w^2 a cos(w t).
TEST(ProbeReader, ReadsVelocityAndAccelerationOfACasingThatSwings) {
  OneSideRotor rotor;
  rotor.casing_damping_ratio = 0;
  scene::Scene scene = test::cell_of(rotor).scene;
  scene.pulses.clear();
  const double a_m = 1e-4, w = std::sqrt(rotor.casing_stiffness_n_per_m / rotor.casing_mass_kg);
  scene.displacement_m(2) = a_m;
  integrate::exact::modes::ModeCache modes;
  const integrate::run::SolverOptions solver;
  const double sample_s = 3.3e-5;
  const Trace trace = trace_run(integrate::start(scene, solver, modes).advance, scene, solver,
                                {.speed_hz = rotor.speed_hz,
                                 .revolutions = 5,
                                 .samples_per_revolution = 128,
                                 .window_revolutions = 5,
                                 .trajectory_revolutions = {},
                                 .probes = casing_probes(2, sample_s)});
  ASSERT_GT(trace.readings.rows(), 1000);
  for (Eigen::Index k = 0; k < trace.readings.rows(); ++k) {
    const double t = sample_s * static_cast<double>(k);
    EXPECT_NEAR(trace.readings(k, 0), a_m * std::cos(w * t), 1e-9 * a_m);
    EXPECT_NEAR(trace.readings(k, 1), -w * a_m * std::sin(w * t), 1e-6 * w * a_m);
    EXPECT_NEAR(trace.readings(k, 2), -w * w * a_m * std::cos(w * t), 1e-5 * w * w * a_m);
  }
}

/// The equations of motion, written without library code, say what accelerates the casing in a rub.
TEST(ProbeReader, AccelerationOfACasingIsItsForceOverItsMass) {
  const OneSideRotor rotor;
  const test::OneSideEquations<double> equations(rotor);
  scene::Scene scene = test::cell_of(rotor).scene;
  integrate::exact::modes::ModeCache modes;
  const integrate::run::SolverOptions solver;
  const int samples = 4096;
  const Trace trace = trace_run(integrate::start(scene, solver, modes).advance, scene, solver,
                                {.speed_hz = rotor.speed_hz,
                                 .revolutions = 12,
                                 .samples_per_revolution = samples,
                                 .window_revolutions = 6,
                                 .trajectory_revolutions = {},
                                 .probes = casing_probes(3, 1 / (rotor.speed_hz * samples))});
  ASSERT_TRUE(trace.last_contact_revolution);
  double largest = 0;
  std::vector<double> off;
  for (std::size_t k = 0; k < trace.trajectory.size(); ++k) {
    const auto& [t_s, state] = trace.trajectory[k];
    const test::OneSideState<double> s{state.displacement_m.x(),          state.displacement_m.y(),
                                       state.stops[0].casing_m.x(),       state.stops[0].casing_m.y(),
                                       state.velocity_m_per_s.x(),        state.velocity_m_per_s.y(),
                                       state.stops[0].casing_m_per_s.x(), state.stops[0].casing_m_per_s.y()};
    test::OneSideState<double> rate{};
    equations(s, rate, t_s);
    largest = std::max(largest, std::abs(rate[7]));
    off.push_back(std::abs(trace.readings(static_cast<Eigen::Index>(k), 2) - rate[7]));
  }
  EXPECT_GT(largest, 1000);
  // The force jumps, or bends, within the interval of a change of contact mode.
  std::ranges::sort(off);
  EXPECT_LT(off[off.size() - 1 - trace.switches.size()], 2e-4 * largest);
}

using Complex = std::complex<double>;
constexpr double pi = std::numbers::pi;

struct Line {
  double order = 0, amplitude_m = 0;
};

/// Readings of a sum of lines, with noise of this standard deviation in x and in y.
std::vector<Complex> readings(const std::vector<Line>& lines, double speed_hz, double sample_s, int count,
                              double noise_m = 0) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> noise(0, 1);
  std::vector<Complex> z;
  for (int j = 0; j < count; ++j) {
    Complex sum(2e-5, -1e-5);
    for (const Line& line : lines)
      sum += std::polar(line.amplitude_m, 2 * pi * line.order * speed_hz * sample_s * j + line.order);
    z.push_back(sum + noise_m * Complex(noise(random), noise(random)));
  }
  return z;
}

TEST(ProbePeriodFind, IsTheSmallestNumberOfTurnsWhoseLinesExplainTheReadings) {
  for (const double speed_hz : {70.0, 61.3, 133.7}) {
    for (const int n : {1, 2, 3, 5, 12}) {
      const auto z = readings({{1, 4e-4}, {1.0 / n, 1e-3}, {-2.0 / n, 1e-4}}, speed_hz, 1e-3, 1200);
      const ProbePeriod found = find_period(z, 1e-3, speed_hz, 0, 64, 12);
      EXPECT_EQ(found.period, n) << speed_hz;
      EXPECT_LT(found.unexplained_share, 1e-12);
      EXPECT_EQ(found.readings, std::min(1200, static_cast<int>(64 / (1e-3 * speed_hz))));
    }
  }
}

TEST(ProbePeriodFind, OfALineWithoutARatioIsNone) {
  const auto z = readings({{1, 4e-4}, {std::sqrt(0.2), 1e-3}}, 70, 1e-3, 1200);
  const ProbePeriod found = find_period(z, 1e-3, 70, 0, 64, 12);
  EXPECT_FALSE(found.period);
  EXPECT_GT(found.unexplained_share, 1e-3);
}

/// The known noise explains the remaining deviations, and no more.
TEST(ProbePeriodFind, SeesThroughNoiseThatItKnowsOf) {
  const double noise_m = 2e-5;
  const auto z = readings({{1, 4e-4}, {0.5, 3e-4}}, 70, 1e-3, 914, noise_m);
  const ProbePeriod known = find_period(z, 1e-3, 70, noise_m, 64, 12);
  EXPECT_EQ(known.period, 2);
  const double energy = 4e-4 * 4e-4 + 3e-4 * 3e-4;
  EXPECT_NEAR(known.unexplained_share, 2 * noise_m * noise_m / energy, 0.2 * 2 * noise_m * noise_m / energy);
  EXPECT_FALSE(find_period(z, 1e-3, 70, 0, 64, 12).period);
}

/// At 70 Hz and a reading every 1 ms the sampling rate is 100/7 orders, so a line at order 10 appears at 10 -
/// 100/7.
TEST(ProbePeriodFind, ALineAboveHalfTheSamplingRateIsFoldedWhereNoLineBelongs) {
  const auto z = readings({{1, 4e-4}, {10, 1e-4}}, 70, 1e-3, 914);
  EXPECT_FALSE(find_period(z, 1e-3, 70, 0, 64, 6).period);
  const auto spectrum = [&] {
    response::spectrum::SpectrumWorkspace workspace;
    return probe_spectrum(z, 1e-3, 70, 64, 1, workspace);
  }();
  const auto at = [&](double order) {
    return spectrum.amplitude(static_cast<int>(std::lround(order * spectrum.turns)));
  };
  EXPECT_EQ(spectrum.turns % 7, 0);
  EXPECT_NEAR(at(1), 4e-4, 1e-12);
  EXPECT_NEAR(at(10 - 100.0 / 7), 1e-4, 1e-12);
}

TEST(ProbePeriodSpectrum, CoversWholePeriods) {
  response::spectrum::SpectrumWorkspace workspace;
  for (const int period : {1, 2, 3}) {
    const auto z = readings({{1, 4e-4}, {1.0 / period, 1e-3}}, 70, 1e-3, 1300);
    const auto spectrum = probe_spectrum(z, 1e-3, 70, 64, period, workspace);
    EXPECT_EQ(spectrum.turns % period, 0);
    EXPECT_GE(spectrum.turns, 32);
    EXPECT_NEAR(spectrum.amplitude(spectrum.turns / period), period == 1 ? 1.4e-3 : 1e-3, 3e-4);
    if (period > 1) {
      EXPECT_NEAR(spectrum.amplitude(spectrum.turns), 4e-4, 1e-12);
      EXPECT_NEAR(spectrum.amplitude(spectrum.turns / period), 1e-3, 1e-12);
    }
  }
  EXPECT_TRUE(probe_spectrum({}, 1e-3, 70, 64, 1, workspace).amplitude_m.empty());
}

TEST(ProbePeriodPairOf, IsTheFirstAtOnePlaceFromTwoDirections) {
  EXPECT_EQ(pair_of({0, 90}, {}), ProbePair(0, 1));
  EXPECT_EQ(pair_of({0, 180, 45}, {0.1, 0.1, 0.1}), ProbePair(0, 2));
  EXPECT_EQ(pair_of({0, 90, 85}, {0.1, 0.2, 0.2}), std::nullopt);
  EXPECT_EQ(pair_of({0, 90, 30}, {0.1, 0.2, 0.2}), ProbePair(1, 2));
  EXPECT_EQ(pair_of({0}, {0.1}), std::nullopt);
}

TEST(ProbePeriodDisplacementOf, UndoesTheDirectionsOfThePair) {
  const std::vector<double> angle_deg{30, -10, 100};
  const Complex z(3e-4, -7e-4);
  Eigen::MatrixXd read(1, 3);
  for (int i = 0; i < 3; ++i) {
    const double angle = angle_deg[static_cast<std::size_t>(i)] * pi / 180;
    read(0, i) = z.real() * std::cos(angle) + z.imag() * std::sin(angle);
  }
  for (const ProbePair& pair : {ProbePair(0, 1), ProbePair(0, 2), ProbePair(1, 2)})
    EXPECT_LT(std::abs(displacement_of(read, pair, angle_deg).at(0) - z), 1e-18);
}

}  // namespace

}  // namespace rubsweep::trace
