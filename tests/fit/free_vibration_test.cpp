#include "rubsweep/fit/free_vibration.hpp"

#include <gtest/gtest.h>

#include "rubsweep/error.hpp"
#include "rubsweep/identify/linear_run.hpp"
#include "scene/kit_machine.hpp"

namespace rubsweep::fit {
namespace {

/// The same kick by steps of a Runge-Kutta method.
TEST(FreeVibration, IsThatOfSteps) {
  for (const model::Machine& machine : {scene::one_side_machine(), scene::light_shaft_machine()}) {
    const scene::PreparedMachine prepared = scene::prepare_machine(machine);
    const identify::SensorRows sensors = identify::sensor_rows(prepared);
    const identify::LinearRun run{.kick = true, .samples = 300};
    const Eigen::MatrixXd steps = identify::run_linear(prepared, run, sensors.rows);
    std::vector<double> since_s;
    for (int k = 0; k < run.samples; ++k) since_s.push_back(k * run.sample_s);
    const Eigen::MatrixXd closed = free_vibration(prepared, sensors.rows, since_s);
    EXPECT_LT((closed - steps).cwiseAbs().maxCoeff(), 1e-7 * steps.cwiseAbs().maxCoeff());
  }
}

TEST(FreeVibration, NothingMovesBeforeTheKickAndNothingWithoutIt) {
  model::Machine machine = scene::one_side_machine();
  const scene::PreparedMachine prepared = scene::prepare_machine(machine);
  EXPECT_EQ(free_vibration(prepared, identify::sensor_rows(prepared).rows, {-1, 0}).norm(), 0);
  machine.kick.reset();
  const scene::PreparedMachine quiet = scene::prepare_machine(machine);
  EXPECT_THROW(free_vibration(quiet, identify::sensor_rows(quiet).rows, {1}), ConfigError);
}

}  // namespace
}  // namespace rubsweep::fit
