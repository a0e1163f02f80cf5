#include "rubtrace/experiment_tables.hpp"

#include <gtest/gtest.h>

namespace rubsweep::apps {

using namespace linear;

namespace {

const LinearRun ramp{.from_hz = 10, .rate_hz_per_s = 4, .sample_s = 0.5, .samples = 2};

Eigen::MatrixXd two_sensors() {
  Eigen::MatrixXd signal_m(2, 2);
  signal_m << 1e-6, 2e-6, 3e-6, 4e-6;
  return signal_m;
}

/// A kit whose second sensor alone has a name.
model::Machine with_names() {
  model::RotorKit kit;
  kit.sensors = {{}, {.name = "DE y"}, {}};
  return {.rotor = kit, .stops = {}, .kick = {}};
}

TEST(ExperimentTables, OfAFreeResponse) {
  const ExperimentTables tables = tables_of(
      FreeResponse{.run = {.kick = true, .sample_s = 0.5, .samples = 2},
                   .signal_m = two_sensors(),
                   .angle_deg = {0, 90},
                   .decay = {std::nullopt,
                             FreeDecay{.natural_frequency_hz = 30, .damping_ratio = 0.02, .misfit = 1e-3}}},
      with_names());
  EXPECT_EQ(tables.sensors_csv,
            "t_s,speed_hz,shaft_angle_rad,sensor_0_m,sensor_1_m\n0,0,0,1e-06,2e-06\n0.5,0,0,3e-06,4e-06\n");
  EXPECT_EQ(tables.identification_csv,
            "quantity,sensor,value\nnatural_frequency_hz,1,30\ndamping_ratio,1,0.02\nmisfit,1,0.001\n");
  EXPECT_EQ(tables.summary,
            "sensor 0 (0 deg)  does not see the kick\n"
            "sensor 1 (DE y, 90 deg)  natural frequency 30 Hz, damping ratio 0.02, misfit 0.001\n");
  EXPECT_TRUE(tables.bode_csv.empty());
}

TEST(ExperimentTables, OfARunUp) {
  const std::vector<BodePoint> plot{{.speed_hz = 10, .amplitude_m = 1e-4, .phase_deg = -90}};
  const ExperimentTables tables =
      tables_of(RunUp{.run = ramp,
                      .signal_m = two_sensors(),
                      .angle_deg = {0, 90, 45},
                      .bode = {plot, plot, plot},
                      .sees = {true, true, false},
                      .speed_of_largest_1x_hz = {10, 11, std::nullopt},
                      .resonance = {RampResonance{9.75, 0.02, 1e-3, 9, 11}, {}, {}},
                      .largest_amplitude_m = {1e-4, 2e-4, 1e-19}},
                with_names());
  EXPECT_EQ(tables.bode_csv,
            "speed_hz,sensor_0_amplitude_m,sensor_0_phase_deg,sensor_1_amplitude_m,sensor_1_phase_deg,"
            "sensor_2_amplitude_m,sensor_2_phase_deg\n10,1e-04,-90,1e-04,-90,1e-04,-90\n");
  EXPECT_EQ(tables.identification_csv,
            "quantity,sensor,value\ncritical_speed_hz,0,10\nspeed_of_largest_1x_hz,0,10\n"
            "largest_amplitude_m,0,1e-04\n"
            "resonance_frequency_hz,0,9.75\nresonance_damping_ratio,0,0.02\nresonance_misfit,0,0.001\n"
            "critical_speed_hz,1,11\nspeed_of_largest_1x_hz,1,11\nlargest_amplitude_m,1,2e-04\n");
  EXPECT_EQ(
      tables.summary,
      "sensor 0 (0 deg)  1X largest at 10 Hz (600 rpm) of this ramp, 0.0001 m; "
      "resonance by a fit to the ramp at 9.75 Hz, damping ratio 0.02, misfit 0.001\n"
      "sensor 1 (DE y, 90 deg)  1X largest at 11 Hz (660 rpm) of this ramp, 0.0002 m; resonance: no single "
      "mode fits\n"
      "sensor 2 (45 deg)  does not see the unbalance\n");
}

TEST(ExperimentTables, OfARunUpThatPassesNoCriticalSpeed) {
  const std::vector<BodePoint> plot{{10, 1e-4, -10}, {11, 2e-4, -20}};
  RunUp run_up{.run = ramp,
               .signal_m = two_sensors(),
               .angle_deg = {0},
               .bode = {plot},
               .sees = {true},
               .speed_of_largest_1x_hz = {std::nullopt},
               .resonance = {std::nullopt},
               .largest_amplitude_m = {2e-4}};
  ExperimentTables tables = tables_of(run_up, {});
  EXPECT_TRUE(
      tables.summary.ends_with("no largest 1X inside: of what was measured, 10 to 11 Hz (600 to 660 rpm), 1X "
                               "is largest at an end, 0.0002 m\n"));
  EXPECT_EQ(tables.identification_csv, "quantity,sensor,value\nlargest_amplitude_m,0,2e-04\n");
  run_up.bode = {{}};
  EXPECT_NE(tables_of(run_up, {}).summary.find("run up more slowly"), std::string::npos);
}

}  // namespace
}  // namespace rubsweep::apps
