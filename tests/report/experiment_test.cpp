#include "rubsweep/report/experiment.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <string>

#include "scene/one_side_machine.hpp"

namespace rubsweep::report {
namespace {

/// "quantity,sensor" -> value
std::map<std::string, double> values(const std::string& csv) {
  std::map<std::string, double> found;
  std::istringstream lines(csv);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "quantity,sensor,value");
  while (std::getline(lines, line)) {
    const auto comma = line.rfind(',');
    found[line.substr(0, comma)] = std::stod(line.substr(comma + 1));
  }
  return found;
}

long line_count(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

TEST(Experiment, FreeResponseFindsTheRotorsFrequencyAndDamping) {
  const scene::Plan plan = scene::make_plan(scene::one_side_machine());
  const Experiment experiment = free_response(plan, 1, {});
  const auto found = values(experiment.identification_csv);
  // The kick points along y: x sees nothing.
  EXPECT_FALSE(found.contains("natural_frequency_hz,0"));
  EXPECT_NE(experiment.summary.find("sensor 0 (0 deg)  does not see the kick\n"), std::string::npos);
  EXPECT_NEAR(found.at("natural_frequency_hz,1"), 30, 1e-6);
  EXPECT_NEAR(found.at("damping_ratio,1"), 0.02, 1e-6);
  EXPECT_EQ(line_count(experiment.sensors_csv), 1002);
  EXPECT_TRUE(experiment.bode_csv.empty());
}

TEST(Experiment, NoiseIsThereAndAlwaysTheSame) {
  const scene::Plan plan = scene::make_plan(scene::one_side_machine());
  const Sampling noisy{.noise_m = 2e-6};
  const Experiment first = free_response(plan, 1, noisy), second = free_response(plan, 1, noisy);
  EXPECT_EQ(first.sensors_csv, second.sensors_csv);
  EXPECT_NE(first.sensors_csv, free_response(plan, 1, {}).sensors_csv);
  const auto found = values(first.identification_csv);
  EXPECT_NEAR(found.at("natural_frequency_hz,1"), 30, 0.02);
  EXPECT_NEAR(found.at("damping_ratio,1"), 0.02, 5e-4);
  EXPECT_FALSE(found.contains("natural_frequency_hz,0"));  // noise is no rotor
}

TEST(Experiment, RunUpFindsTheCriticalSpeed) {
  const scene::Plan plan = scene::make_plan(scene::one_side_machine());
  const Experiment experiment = run_up(plan, 27, 34, 0.5, 1e-5, {});
  const auto found = values(experiment.identification_csv);
  for (const std::string sensor : {"0", "1"}) {
    // A rising speed shifts the peak up by about the rate times the memory 1 / (zeta w0) = 0.27 s.
    EXPECT_NEAR(found.at("critical_speed_hz," + sensor), 30.1, 0.2);
    // Steady: e / (2 zeta).
    EXPECT_NEAR(found.at("largest_amplitude_m," + sensor), 1e-5 / 0.04, 0.1 * 1e-5 / 0.04);
  }
  EXPECT_EQ(line_count(experiment.sensors_csv), 14002);
  EXPECT_GT(line_count(experiment.bode_csv), 25);
  EXPECT_EQ(experiment.bode_csv.substr(0, experiment.bode_csv.find('\n')),
            "speed_hz,sensor_0_amplitude_m,sensor_0_phase_deg,sensor_1_amplitude_m,sensor_1_phase_deg");
}

}  // namespace
}  // namespace rubsweep::report
