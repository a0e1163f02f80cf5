#include "rubsweep/measurement/fit/first_values.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/scene/one_side_machine.hpp"
#include "rubfit/fit_tables.hpp"
#include "rubsweep/measurement/fit/machine_fit.hpp"

namespace rubsweep::fit {
namespace {

double reading_noise(double size_m) {
  static std::mt19937_64 random(17);
  return std::normal_distribution<double>(0, size_m)(random);
}

/// Readings of a single mode hit by a half-sine pulse of 4 ms at `hit_s`, computed by Runge-Kutta steps.
RingDown struck(double frequency_hz, double ratio, double hit_s, double noise_m) {
  const double w = 2 * 3.14159265358979 * frequency_hz, h = 1e-4;
  const auto push = [&](double t) {
    return t > hit_s && t < hit_s + 0.004 ? std::sin(3.14159265358979 * (t - hit_s) / 0.004) : 0;
  };
  const auto rate = [&](double t, const Eigen::Vector2d& s) {
    return Eigen::Vector2d(s(1), push(t) - 2 * ratio * w * s(1) - w * w * s(0));
  };
  RingDown data;
  Eigen::Vector2d state(0, 0);
  std::vector<double> readings;
  for (int k = 0; k < 5000; ++k) {
    const double t = k * h;
    if (k % 10 == 0) {
      data.t_s.push_back(t);
      readings.push_back(state(0));
    }
    const Eigen::Vector2d a = rate(t, state), b = rate(t + h / 2, state + h / 2 * a),
                          c = rate(t + h / 2, state + h / 2 * b), d = rate(t + h, state + h * c);
    state += h / 6 * (a + 2 * b + 2 * c + d);
  }
  data.signal_m = Eigen::Map<const Eigen::VectorXd>(readings.data(), std::ssize(readings));
  data.signal_m *= 3e-4 / data.signal_m.cwiseAbs().maxCoeff();
  for (double& value : data.signal_m.reshaped()) value += reading_noise(noise_m);
  return data;
}

/// The same rotor with a kick of 4 ms along x.
scene::PreparedMachine struck_rotor(const Eigen::VectorXd& values) {
  model::Machine machine = scene::one_side_machine();
  auto& jeffcott = std::get<model::JeffcottRotor>(machine.rotor);
  jeffcott.natural_frequency_hz = values(0);
  jeffcott.damping_ratio = values(1);
  machine.kick->duration_s = 0.004;
  machine.kick->angle_deg = 0;
  return scene::prepare_machine(machine);
}

TEST(FirstValues, TheInstantOfTheHitIsFoundFromFarAway) {
  std::mt19937_64 random(3);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  for (int trial = 0; trial < 3; ++trial) {
    const double frequency_hz = between(20, 40), ratio = between(0.008, 0.04), hit_s = between(0.005, 0.09);
    MachineFit problem{.parameters = {{"frequency", frequency_hz * between(0.93, 1.07), 10, 60, 30},
                                      {"ratio", ratio * between(0.6, 1.6), 1e-3, 0.2, 0.02},
                                      {hit_name, between(0.001, 0.099), 0, 0.1, 1e-2}},
                       .data = {{"ring", struck(frequency_hz, ratio, hit_s, 3e-6), false}},
                       .machine = struck_rotor};
    const MachineFitResult result = fit_machine(problem, {});
    EXPECT_NEAR(result.fit.value(0) / frequency_hz, 1, 2e-3) << trial;
    EXPECT_NEAR(result.fit.value(2), hit_s, 1e-3) << trial;
    const std::string summary = apps::tables_of(problem, result, scene::one_side_machine()).summary;
    EXPECT_EQ(summary.find("warning"), std::string::npos) << summary;
  }
}

TEST(FirstValues, ATenthThatIsLeftIsSaid) {
  // The bounds exclude the true value.
  MachineFit problem{.parameters = {{"frequency", 30, 25, 36, 30},
                                    {"ratio", 0.02, 1e-3, 0.2, 0.02},
                                    {hit_name, 0.03, 0.025, 0.035, 1e-2}},
                     .data = {{"ring", struck(31, 0.02, 0.01, 3e-6), false}},
                     .machine = struck_rotor};
  const std::string summary =
      apps::tables_of(problem, fit_machine(problem, {}), scene::one_side_machine()).summary;
  EXPECT_NE(summary.find(" % of ring are left over"), std::string::npos) << summary;
}

}  // namespace
}  // namespace rubsweep::fit
