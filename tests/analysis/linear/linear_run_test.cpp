#include "rubsweep/analysis/linear/linear_run.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "core/scene/kit_machine.hpp"
#include "core/scene/misaligned_machine.hpp"
#include "core/scene/table_machine.hpp"
#include "rubsweep/core/scene/build_scene.hpp"
#include "rubsweep/core/scene/constant_load.hpp"
#include "rubsweep/core/structure/assembly.hpp"

namespace rubsweep::linear {
namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

constexpr double w0 = 2 * pi * 30, zeta = 0.02;

/// Reference solution of z'' + 2 zeta w0 z' + w0^2 z = e (phi'^2 - i phi'') e^{i phi} + pulse in y, by the
/// classical Runge-Kutta method with 20 steps per sample.
std::vector<Complex> reference(const LinearRun& run, Complex z, Complex v) {
  const auto acceleration = [&](double t, Complex at, Complex speed) {
    const double rate = 2 * pi * shaft_speed_hz(run, t);
    Complex force = run.eccentricity_m * Complex(rate * rate, -2 * pi * run.rate_hz_per_s) *
                    std::polar(1.0, shaft_angle_rad(run, t));
    if (run.kick && t < 0.005) force += Complex(0, 200 / 0.8 * std::sin(pi * t / 0.005));
    return force - 2 * zeta * w0 * speed - w0 * w0 * at;
  };
  std::vector<Complex> samples;
  const double h = run.sample_s / 20;
  for (int k = 0; k < run.samples; ++k) {
    samples.push_back(z);
    for (int i = 0; i < 20; ++i) {
      const double t = k * run.sample_s + i * h;
      const Complex k1 = acceleration(t, z, v);
      const Complex k2 = acceleration(t + h / 2, z + h / 2 * v, v + h / 2 * k1);
      const Complex k3 = acceleration(t + h / 2, z + h / 2 * v + h * h / 4 * k1, v + h / 2 * k2);
      const Complex k4 = acceleration(t + h, z + h * v + h * h / 2 * k2, v + h * k3);
      z += h * v + h * h / 6 * (k1 + k2 + k3);
      v += h / 6 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    }
  }
  return samples;
}

void expect_same(const Eigen::MatrixXd& signal, const std::vector<Complex>& expected, double tolerance) {
  ASSERT_EQ(signal.rows(), static_cast<Eigen::Index>(expected.size()));
  for (Eigen::Index k = 0; k < signal.rows(); ++k) {
    ASSERT_NEAR(signal(k, 0), expected[static_cast<std::size_t>(k)].real(), tolerance) << k;
    ASSERT_NEAR(signal(k, 1), expected[static_cast<std::size_t>(k)].imag(), tolerance) << k;
  }
}

TEST(LinearRun, FreeResponseIsThatOfTheOscillator) {
  const scene::PreparedMachine prepared = scene::prepare_machine(scene::one_side_machine());
  const LinearRun run{.kick = true, .samples = 300};
  const SensorRows sensors = sensor_rows(prepared);
  EXPECT_EQ(sensors.angle_deg, (std::vector<double>{0, 90}));
  expect_same(run_linear(prepared, run, sensors.rows), reference(run, 0, 0), 1e-9);
}

TEST(LinearRun, RunUpFeelsTheAngularAcceleration) {
  const scene::PreparedMachine prepared = scene::prepare_machine(scene::one_side_machine());
  const LinearRun run{.from_hz = 20, .rate_hz_per_s = 40, .eccentricity_m = 1e-4, .samples = 500};
  const double w = 2 * pi * 20;
  const Complex start = 1e-4 * w * w / Complex(w0 * w0 - w * w, 2 * zeta * w0 * w);
  expect_same(run_linear(prepared, run, sensor_rows(prepared).rows),
              reference(run, start, Complex(0, w) * start), 2e-9);
}

TEST(LinearRun, FromRestTheUnbalanceBeginsAtOnce) {
  model::Machine machine = scene::one_side_machine();
  machine.kick.reset();
  machine.start = {.at_rest = true};
  LinearRun run{.from_hz = 20, .rate_hz_per_s = 40, .eccentricity_m = 1e-4, .samples = 500};
  for (const Driven driven : {Driven::by_all, Driven::in_phase}) {
    run.driven = driven;
    const scene::PreparedMachine prepared = scene::prepare_machine(machine);
    expect_same(run_linear(prepared, run, sensor_rows(prepared).rows), reference(run, 0, 0), 2e-9);
  }
}

TEST(LinearRun, AtConstantSpeedAKitStaysOnItsQuietMotion) {
  model::Machine machine = scene::light_shaft_machine();
  model::kit_of(machine)->discs[0].position_m = 0.12;
  model::kit_of(machine)->shaft[0].density_kg_per_m3 = 7850;
  model::kit_of(machine)->modes = 2;
  model::kit_of(machine)->bow =
      model::Bow{.shape = model::BowMode{.mode = 1, .amplitude_m = 1e-4}, .phase_deg = 40};
  model::kit_of(machine)->sensors = {{.position_m = 0.1, .angle_deg = 30}};
  machine.gravity_m_per_s2 = 9.81;
  const scene::PreparedMachine prepared = scene::prepare_machine(machine);
  const LinearRun run{.from_hz = 50, .eccentricity_m = 1e-4, .samples = 60};
  const SensorRows sensors = sensor_rows(prepared);
  ASSERT_EQ(sensors.rows.rows(), 1);
  const Eigen::MatrixXd signal = run_linear(prepared, run, sensors.rows);
  const scene::Cell cell = scene::build_cell(prepared, 50, scene::Eccentricity{1e-4});
  // The cell starts at the smallest gap, the run at the mark: both follow the same ellipse with the same
  // range.
  for (int k = 0; k < 60; ++k) EXPECT_NEAR(signal(k, 0), signal(k % 20, 0), 1e-9) << k;
  Eigen::VectorXd whole(20000);
  for (int k = 0; k < 20000; ++k) whole(k) = (sensors.rows * cell.quiet.displacement(2 * pi * k / 20000))(0);
  EXPECT_LE(signal.maxCoeff(), whole.maxCoeff() + 1e-9);
  EXPECT_GE(signal.minCoeff(), whole.minCoeff() - 1e-9);
  // Twenty samples per turn miss the extremes by at most 1 - cos(pi / 20) of the amplitude.
  EXPECT_GT(signal.maxCoeff() - signal.minCoeff(),
            std::cos(pi / 20) * (whole.maxCoeff() - whole.minCoeff()) - 1e-9);
}

/// At constant speed the run stays on the quiet motion with both orders, whereas the 1X phasor contains one
/// only.
TEST(LinearRun, AMisalignedCouplingForcesTwicePerTurn) {
  const scene::PreparedMachine prepared = scene::prepare_machine(scene::MisalignedRotor{}.machine());
  const SensorRows sensors = sensor_rows(prepared);
  LinearRun run{.from_hz = 19, .eccentricity_m = 1e-5, .sample_s = 0.003, .samples = 100};
  const double w = 2 * pi * run.from_hz;
  const structure::LinearSystem system = structure::system_at(prepared.assembly, w);
  for (const bool all : {true, false}) {
    run.driven = all ? Driven::by_all : Driven::in_phase;
    const Eigen::VectorXd load =
        all ? scene::constant_load_n(prepared) : Eigen::VectorXd(Eigen::VectorXd::Zero(system.coordinates()));
    const scene::QuietMotion quiet =
        scene::quiet_motion(system, w, 1e-5 * w * w * system.unbalance_kg, load,
                            all ? prepared.assembly.second_n : Eigen::VectorXcd());
    const Eigen::MatrixXd signal = run_linear(prepared, run, sensors.rows);
    for (const int k : {0, 17, 99}) {
      const Eigen::VectorXd expected =
          sensors.rows * quiet.displacement(shaft_angle_rad(run, k * run.sample_s));
      EXPECT_LT((signal.row(k).transpose() - expected).norm(), 1e-7 * expected.norm()) << all << ' ' << k;
    }
  }
}

/// Each impulse J = 0.02 N s at 0.4 rad from x starts a free vibration z(t) = J / (m wd) e^{-zeta w0 t} sin
/// wd t.
TEST(LinearRun, ASlowRunUpFollowsTheQuietMotionsOfSupportsByATable) {
  const scene::PreparedMachine prepared = scene::prepare_machine(scene::table_machine());
  const LinearRun run{
      .from_hz = 60, .rate_hz_per_s = 2, .eccentricity_m = 1e-4, .sample_s = 0.01, .samples = 601};
  const SensorRows sensors = sensor_rows(prepared);
  const Eigen::MatrixXd signal = run_linear(prepared, run, sensors.rows);
  for (const int k : {0, 250, 600}) {
    const double t = k * run.sample_s, w = 2 * pi * shaft_speed_hz(run, t);
    const structure::LinearSystem system = structure::system_at(prepared.assembly, w);
    const scene::QuietMotion quiet = scene::quiet_motion(system, w, 1e-4 * w * w * system.unbalance_kg,
                                                         Eigen::VectorXd::Zero(system.coordinates()));
    const Eigen::VectorXd expected = sensors.rows * quiet.displacement(shaft_angle_rad(run, t));
    const Eigen::VectorXd found = signal.row(k).transpose();
    const double size = (sensors.rows.cast<Complex>() * quiet.amplitude).norm();
    EXPECT_LT((found - expected).norm(), 5e-3 * size) << k;
  }
}

TEST(LinearRun, AFaultyBearingStrikesByTheShaftsAngle) {
  scene::PreparedMachine prepared = scene::prepare_machine(scene::one_side_machine());
  constexpr double angle = 0.4, multiple = 2.7, phase_periods = 0.3;
  prepared.assembly.impulses.push_back({0.02 * (prepared.assembly.system.points[0].map.transpose() *
                                                Eigen::Vector2d(std::cos(angle), std::sin(angle))),
                                        multiple, phase_periods});
  for (const double rate_hz_per_s : {40.0, -30.0, 0.0}) {
    const LinearRun run{.from_hz = 20, .rate_hz_per_s = rate_hz_per_s, .samples = 300};
    const double wd = w0 * std::sqrt(1 - zeta * zeta);
    std::vector<Complex> expected(300);
    for (int k = 0; k < 300; ++k) {
      const double t = k * run.sample_s;
      for (int i = 0;; ++i) {
        // Finds the instant of the impulse by bisection on the shaft angle.
        double low = 0, high = t;
        const double due = 2 * pi * (i + phase_periods) / multiple;
        if (shaft_angle_rad(run, t) < due) break;
        for (int j = 0; j < 60; ++j) {
          const double middle = (low + high) / 2;
          (shaft_angle_rad(run, middle) < due ? low : high) = middle;
        }
        expected[static_cast<std::size_t>(k)] += 0.02 / (0.8 * wd) * std::exp(-zeta * w0 * (t - high)) *
                                                 std::sin(wd * (t - high)) * std::polar(1.0, angle);
      }
    }
    expect_same(run_linear(prepared, run, sensor_rows(prepared).rows), expected, 1e-11);
  }
}

}  // namespace
}  // namespace rubsweep::linear
