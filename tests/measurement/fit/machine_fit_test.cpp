#include "rubsweep/measurement/fit/machine_fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "core/scene/one_side_machine.hpp"
#include "maps/batch/message_of.hpp"
#include "rubfit/fit_tables.hpp"
#include "rubsweep/analysis/linear/linear_run.hpp"
#include "rubsweep/core/error.hpp"
#include "rubsweep/measurement/fit/modelled_data.hpp"
#include "rubsweep/measurement/fit/ramp_phasor.hpp"

namespace rubsweep::fit {
namespace {

/// A Jeffcott rotor whose frequency and damping ratio are the first two parameters.
scene::PreparedMachine rotor(const Eigen::VectorXd& values) {
  model::Machine machine = scene::one_side_machine();
  auto& jeffcott = std::get<model::JeffcottRotor>(machine.rotor);
  jeffcott.natural_frequency_hz = values(0);
  jeffcott.damping_ratio = values(1);
  return scene::prepare_machine(machine);
}

const Eigen::VectorXd truth = Eigen::Vector2d(31, 0.015);

/// Start values differ from the truth as much as those of a data sheet.
const std::vector<Parameter> rotor_parameters{{"frequency", 30, 25, 36, 30},
                                              {"ratio", 0.02, 1e-3, 0.2, 0.02}};

double noise(double size_m) {
  static std::mt19937_64 random(11);
  return std::normal_distribution<double>(0, size_m)(random);
}

MeasuredData ring_down(double noise_m) {
  RingDown data;
  for (int k = 0; k < 1500; ++k) data.t_s.push_back(0.006 + 1e-3 * k);
  const scene::PreparedMachine machine = rotor(truth);
  std::vector<double> since_s = data.t_s;
  for (double& t : since_s) t -= 0.001;
  data.signal_m = 0.7 * free_vibration(machine, linear::sensor_rows(machine).rows, since_s);
  for (double& value : data.signal_m.reshaped()) value += 1e-4 + noise(noise_m);
  return {"ring", data, false};
}

MeasuredData run_up(double noise_m) {
  RunUp data{.ramp = {20, 4}, .t_s = {}, .phasor_m = {}, .window_turns = 2};
  for (int k = 0; k < 90; ++k) data.t_s.push_back(0.06 * k);
  const scene::PreparedMachine machine = rotor(truth);
  const RampParts parts = ramp_parts(machine, linear::sensor_rows(machine).rows, data.ramp, data.t_s, 2);
  data.phasor_m = std::polar(1.0, 0.5) * (2e-5 * parts.per_eccentricity + parts.bow_m);
  for (auto& value : data.phasor_m.reshaped()) value += std::complex<double>(noise(noise_m), noise(noise_m));
  return {"run", data, false};
}

void expect_told(const MachineFitResult& result, Eigen::Index parameter, double value) {
  EXPECT_LT(std::abs(result.fit.value(parameter) - value), 4 * result.uncertainty.standard_error(parameter))
      << parameter;
}

TEST(MachineFit, RingDownTellsFrequencyAndDamping) {
  MachineFit problem{.parameters = rotor_parameters, .data = {ring_down(2e-5)}, .machine = rotor};
  problem.parameters.push_back({hit_name, 0, -0.005, 0.005, 1e-3});
  const MachineFitResult result = fit_machine(problem, {});
  expect_told(result, 0, 31);
  expect_told(result, 1, 0.015);
  expect_told(result, 2, 0.001);
  EXPECT_LT(result.uncertainty.standard_error(0), 0.02);
  const apps::FitTables tables = apps::tables_of(problem, result, scene::one_side_machine());
  EXPECT_EQ(tables.summary.find("something is missing"), std::string::npos) << tables.summary;
  EXPECT_TRUE(tables.parameters_csv.starts_with(
      "parameter,value,standard_error,low_95,high_95,start,at_bound\nfrequency,"));
  EXPECT_EQ(std::ranges::count(tables.residuals_csv, '\n'), 1 + 2 * 1500);
}

TEST(MachineFit, WhatIsMissingIsNamed) {
  MeasuredData data = ring_down(2e-6);
  auto& ring = std::get<RingDown>(data.data);
  for (Eigen::Index k = 0; k < ring.signal_m.rows(); ++k)
    ring.signal_m(k, 1) += 8e-6 * std::sin(2 * 3.14159265358979 * 50 * ring.t_s[static_cast<std::size_t>(k)]);
  MachineFit problem{.parameters = rotor_parameters, .data = {data}, .hit_s = 0.001, .machine = rotor};
  const std::string summary =
      apps::tables_of(problem, fit_machine(problem, {}), scene::one_side_machine()).summary;
  EXPECT_NE(summary.find("of sensor 1: a vibration of 50"), std::string::npos) << summary;
}

TEST(MachineFit, ARunUpOfTheRightMachineRaisesNoWarning) {
  MeasuredData data = run_up(2e-7);
  auto& run = std::get<RunUp>(data.data);
  // Errors of smoothed marks are correlated and amount to 0.5 % of 1X.
  std::complex<double> error = 0;
  for (Eigen::Index k = 0; k < run.phasor_m.rows(); ++k) {
    error = 0.8 * error + std::complex<double>(0, noise(0.003));
    run.phasor_m.row(k) *= 1.0 + error;
  }
  MachineFit problem{.parameters = rotor_parameters,
                     .data = {data},
                     .eccentricity_m = 2e-5,
                     .mark_deg = 0.5 * 180 / 3.14159265358979,
                     .machine = rotor};
  std::string summary = apps::tables_of(problem, fit_machine(problem, {}), scene::one_side_machine()).summary;
  EXPECT_EQ(summary.find("warning"), std::string::npos) << summary;
  // With a wrong unbalance the residuals are not noise.
  problem.eccentricity_m = 1.8e-5;
  summary = apps::tables_of(problem, fit_machine(problem, {}), scene::one_side_machine()).summary;
  EXPECT_NE(summary.find("something is missing"), std::string::npos) << summary;
}

TEST(MachineFit, RunUpTellsUnbalanceAndMarkToo) {
  MachineFit problem{.parameters = rotor_parameters, .data = {run_up(5e-6)}, .machine = rotor};
  problem.parameters.push_back({eccentricity_name, 1e-5, 1e-6, 1e-4, 1e-5});
  problem.parameters.push_back({mark_name, 0, -180, 180, 30});
  const MachineFitResult result = fit_machine(problem, {});
  expect_told(result, 0, 31);
  expect_told(result, 1, 0.015);
  expect_told(result, 2, 2e-5);
  expect_told(result, 3, 0.5 * 180 / 3.14159265358979);
  EXPECT_TRUE(untold_combinations(result.uncertainty, problem.parameters).empty());
}

TEST(MachineFit, AMarkIsFoundFromTheOtherSideOfTheShaft) {
  MachineFit problem{.parameters = rotor_parameters, .data = {run_up(5e-6)}, .machine = rotor};
  problem.parameters.push_back({eccentricity_name, 1e-5, 1e-6, 1e-4, 1e-5});
  for (const double start_deg : {-150.0, -60.0, 120.0, 175.0}) {
    problem.parameters.push_back({mark_name, start_deg, -180, 180, 30});
    const MachineFitResult result = fit_machine(problem, {});
    expect_told(result, 0, 31);
    expect_told(result, 3, 0.5 * 180 / 3.14159265358979);
    problem.parameters.pop_back();
  }
}

TEST(MachineFit, AMarkIsFoundBehindItsBound) {
  MeasuredData data = run_up(5e-6);
  // The mark of the data is at 178 degrees; with a rotor frequency that is too low it appears beyond 180.
  std::get<RunUp>(data.data).phasor_m *= std::polar(1.0, 178 * 3.14159265358979 / 180 - 0.5);
  MachineFit problem{.parameters = rotor_parameters, .data = {data}, .machine = rotor};
  problem.parameters[0].start = 29.8;
  problem.parameters.push_back({eccentricity_name, 1e-5, 1e-6, 1e-4, 1e-5});
  problem.parameters.push_back({mark_name, -170, -180, 180, 30});
  const MachineFitResult result = fit_machine(problem, {});
  expect_told(result, 0, 31);
  expect_told(result, 3, 178);
  EXPECT_FALSE(result.fit.at_bound[3]);
}

TEST(MachineFit, DataOfTwoKindsCountByTheirNoise) {
  MachineFit problem{.parameters = rotor_parameters,
                     .data = {ring_down(2e-4), run_up(5e-7)},
                     .eccentricity_m = 2e-5,
                     .mark_deg = 0.5 * 180 / 3.14159265358979,
                     .hit_s = 0.001,
                     .machine = rotor};
  const MachineFitResult both = fit_machine(problem, {});
  expect_told(both, 0, 31);
  expect_told(both, 1, 0.015);
  problem.data.erase(problem.data.begin());
  const MachineFitResult good = fit_machine(problem, {});
  EXPECT_NEAR(both.uncertainty.standard_error(0) / good.uncertainty.standard_error(0), 1, 0.3);
}

TEST(MachineFit, ARateTakesTheSpeedsOfAnEvenRampAlone) {
  MeasuredData data = run_up(2e-7);
  MachineFit problem{.parameters = rotor_parameters,
                     .data = {data},
                     .eccentricity_m = 2e-5,
                     .mark_deg = 0.5 * 180 / 3.14159265358979,
                     .machine = rotor};
  problem.parameters.push_back({rate_name, 3.9, 3, 5, 0.1});
  expect_told(fit_machine(problem, {}), 2, 4);
  auto& run = std::get<RunUp>(problem.data.front().data);
  run.ramp = {.from_hz = 20, .rate_hz_per_s = 0, .knot_s = {0, 2, 5.4}, .knot_hz = {20, 27, 41.6}};
  EXPECT_EQ(message_of<ConfigError>([&] { fit_machine(problem, {}); }),
            "run: has a speed that changes unevenly, allowed with rate_hz_per_s: one that changes evenly");
}

TEST(MachineFit, FirstValuesThatAreNotAllowedAreRefusedInTheirOwnWords) {
  MachineFit problem{.parameters = rotor_parameters, .data = {ring_down(2e-5)}, .machine = rotor};
  std::get<RingDown>(problem.data.front().data).signal_m.conservativeResize(Eigen::NoChange, 3);
  EXPECT_EQ(message_of<ConfigError>([&] { fit_machine(problem, {}); }),
            "ring: has 3 sensors, allowed: as many as the configuration, 2, or fewer");
}

TEST(MachineFit, RubsAreFollowedAlongTheStepsAlone) {
  // An artificial rub whose lines are the parameters themselves.
  RubLines data{.speed_hz = 70, .turns = 1, .order = {1, -1}, .line_m = Eigen::Vector2cd(31, 0.015)};
  std::vector<double> followed;
  MachineFit problem{
      .parameters = rotor_parameters,
      .data = {{"rub", data, false}},
      .machine = rotor,
      .rub_lines =
          [](const scene::PreparedMachine& machine, const RubLines&, double) {
            const auto& there = std::get<model::JeffcottRotor>(machine.machine.rotor);
            return Eigen::VectorXcd(Eigen::Vector2cd(there.natural_frequency_hz, there.damping_ratio));
          },
      .follow_rub =
          [&](const scene::PreparedMachine& machine, const RubLines&, double) {
            followed.push_back(std::get<model::JeffcottRotor>(machine.machine.rotor).natural_frequency_hz);
          }};
  const MachineFitResult result = fit_machine(problem, {});
  ASSERT_GE(followed.size(), 2u);
  EXPECT_EQ(followed.front(), 30);
  EXPECT_DOUBLE_EQ(followed.back(), result.fit.value(0));
  // The first values are reported by the fit, by its descent, and as the step before the first one.
  EXPECT_LE(followed.size(), static_cast<std::size_t>(result.fit.iterations) + 3)
      << "no steps of derivatives";
}

TEST(MachineFit, AParameterTooFewIsFoundOut) {
  MachineFit problem{
      .parameters = rotor_parameters, .data = {run_up(2e-7)}, .eccentricity_m = 2e-5, .machine = rotor};
  problem.parameters.push_back({mark_name, 0, -180, 180, 30});
  const MachineFitResult with = fit_machine(problem, {});
  problem.parameters.pop_back();
  EXPECT_NE(apps::comparison_text(with, fit_machine(problem, {}), "mark_deg").find("the data need it"),
            std::string::npos);
}

}  // namespace
}  // namespace rubsweep::fit
