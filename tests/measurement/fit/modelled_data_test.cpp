#include "rubsweep/measurement/fit/modelled_data.hpp"

#include <gtest/gtest.h>

#include "core/scene/kit_machine.hpp"
#include "core/scene/table_machine.hpp"
#include "rubsweep/analysis/linear/linear_run.hpp"
#include "rubsweep/core/error.hpp"

namespace rubsweep::fit {
namespace {

/// Data with 1X of two sensors at three speeds.
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
  // Eliminated: the scale of the kick, and an offset for each of three sensors.
  const MeasuredData ring{.name = "ring.csv",
                          .data = RingDown{.t_s = {0, 1}, .signal_m = Eigen::MatrixXd(2, 3)}};
  EXPECT_EQ(eliminated_of(ring), 4);
}

TEST(ModelledData, AreMadeOnceForAllEccentricitiesAndMarks) {
  MachineFit problem;
  problem.parameters = {{.name = "rotor.damping_ratio"}, {.name = eccentricity_name}, {.name = mark_name}};
  problem.data.resize(1);
  LastRamps ramps(problem);
  const RunUp run;
  int made = 0;
  const auto ask = [&](double damping_ratio, double eccentricity_m, double mark_deg) {
    ramps.of(problem, run, Eigen::Vector3d(damping_ratio, eccentricity_m, mark_deg), [&] {
      ++made;
      return RampParts{};
    });
  };
  ask(0.02, 1e-5, 10);
  ask(0.02, 2e-5, 70);
  EXPECT_EQ(made, 1);
  ask(0.03, 1e-5, 10);
  EXPECT_EQ(made, 2);
  ask(0.02, 5e-5, 0);
  EXPECT_EQ(made, 2);
  const RunUp other;
  ramps.of(problem, other, Eigen::Vector3d(0.02, 1e-5, 10), [&] {
    ++made;
    return RampParts{};
  });
  EXPECT_EQ(made, 3);
}

/// Compares the closed form with steps of a Runge-Kutta method.
TEST(ModelledData, IsThatOfSteps) {
  for (const model::Machine& machine : {scene::one_side_machine(), scene::light_shaft_machine()}) {
    const scene::PreparedMachine prepared = scene::prepare_machine(machine);
    const linear::SensorRows sensors = linear::sensor_rows(prepared);
    const linear::LinearRun run{.kick = true, .samples = 300};
    const Eigen::MatrixXd steps = linear::run_linear(prepared, run, sensors.rows);
    std::vector<double> since_s;
    for (int k = 0; k < run.samples; ++k) since_s.push_back(k * run.sample_s);
    const Eigen::MatrixXd closed = free_vibration(prepared, sensors.rows, since_s);
    EXPECT_LT((closed - steps).cwiseAbs().maxCoeff(), 1e-7 * steps.cwiseAbs().maxCoeff());
  }
}

TEST(ModelledData, NothingMovesBeforeTheKickAndNothingWithoutIt) {
  model::Machine machine = scene::one_side_machine();
  const scene::PreparedMachine prepared = scene::prepare_machine(machine);
  EXPECT_EQ(free_vibration(prepared, linear::sensor_rows(prepared).rows, {-1, 0}).norm(), 0);
  machine.kick.reset();
  const scene::PreparedMachine quiet = scene::prepare_machine(machine);
  EXPECT_THROW(free_vibration(quiet, linear::sensor_rows(quiet).rows, {1}), ConfigError);
}

TEST(ModelledDataFitProblem, TakesANumberFromTheParametersWhereItIsOne) {
  MachineFit problem;
  problem.parameters = {{.name = "rotor.damping_ratio"}, {.name = mark_name}};
  const Eigen::Vector2d values(0.02, 40);
  EXPECT_EQ(value_named(problem, values, mark_name, 7), 40);
  EXPECT_EQ(value_named(problem, values, hit_name, 7), 7);
}

model::Machine open_number_of_modes(double length_m) {
  model::Machine machine = scene::light_shaft_machine();
  auto& kit = std::get<model::RotorKit>(machine.rotor);
  kit.shaft.front().density_kg_per_m3 = 7850;
  kit.shaft.front().length_m = length_m;
  kit.supports.back().position_m = length_m;
  kit.modes = std::nullopt;
  kit.modes_up_to_hz = 400;
  return machine;
}

TEST(ModelledDataFitProblem, IsTheMachineThatIsPreparedAtOnce) {
  const model::Machine machine = open_number_of_modes(0.4);
  const scene::PreparedMachine first = scene::prepare_machine(machine);
  const scene::PreparedMachine again = prepare_again(machine, first);
  EXPECT_EQ(again.assembly.system.mass, first.assembly.system.mass);
  EXPECT_EQ(again.assembly.system.stiffness, first.assembly.system.stiffness);
  EXPECT_EQ(again.assembly.system.damping, first.assembly.system.damping);
}

TEST(ModelledDataFitProblem, KeepsTheNumberOfModes) {
  const scene::PreparedMachine first = scene::prepare_machine(open_number_of_modes(0.4));
  const model::Machine longer = open_number_of_modes(0.8);
  const scene::PreparedMachine alone = scene::prepare_machine(longer);
  ASSERT_NE(alone.assembly.system.coordinates(), first.assembly.system.coordinates());
  EXPECT_EQ(prepare_again(longer, first).assembly.system.coordinates(), first.assembly.system.coordinates());
}

TEST(ModelledDataFitProblem, RefusesWhatIsNotAllowed) {
  const scene::PreparedMachine first = scene::prepare_machine(open_number_of_modes(0.4));
  model::Machine machine = open_number_of_modes(0.4);
  std::get<model::RotorKit>(machine.rotor).discs.front().mass_kg = -1;
  EXPECT_THROW(prepare_again(machine, first), ConfigError);
}

TEST(ModelledDataFitProblem, SupportsFollowTheirTables) {
  const model::Machine machine = scene::table_machine();
  const scene::PreparedMachine first = scene::prepare_machine(machine), again = prepare_again(machine, first);
  for (const double speed_hz : scene::table_speeds_hz) {
    const scene::PreparedMachine there = scene::prepared_at(again, speed_hz),
                                 expected = scene::prepared_at(first, speed_hz);
    EXPECT_EQ(there.assembly.system.stiffness, expected.assembly.system.stiffness) << speed_hz;
    EXPECT_EQ(there.assembly.system.damping, expected.assembly.system.damping) << speed_hz;
  }
  EXPECT_NE(scene::prepared_at(again, scene::table_speeds_hz.front()).assembly.system.stiffness,
            scene::prepared_at(again, scene::table_speeds_hz.back()).assembly.system.stiffness);
  EXPECT_THROW(scene::prepared_at(again, 19), ConfigError);
}

TEST(ModelledDataFitProblem, RefusesFrictionThatDrives) {
  const scene::PreparedMachine first = scene::prepare_machine(open_number_of_modes(0.4));
  model::Machine machine = open_number_of_modes(0.4);
  machine.stops.front().friction = model::StribeckFriction{{0, 0, 0, -0.1, 100, 0}};
  EXPECT_THROW(scene::prepare_machine(machine), ConfigError);
  EXPECT_THROW(prepare_again(machine, first), ConfigError);
}

}  // namespace
}  // namespace rubsweep::fit
