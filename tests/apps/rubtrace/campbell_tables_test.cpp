#include "rubtrace/campbell_tables.hpp"

#include <gtest/gtest.h>

#include <complex>

namespace rubsweep::apps {
namespace {

using linear::Campbell;
using Complex = std::complex<double>;

Campbell one_mode() {
  Campbell diagram;
  diagram.position_m = {0, 0.5};
  diagram.modes = {{.number = 3, .points = {{10, 40, 0.02, 1}, {20, 42, -0.01, 0.5}}}};
  diagram.critical_speeds = {{.mode = 3, .speed_hz = 41.5, .damping_ratio = 0.02, .forward_share = 0.1}};
  diagram.shapes = {{.mode = 3,
                     .speed_hz = 41.5,
                     .frequency_hz = 41.5,
                     .forward_share = 0.1,
                     .x = Eigen::Vector2cd(Complex(1, 0), Complex(0.5, 0.25)),
                     .y = Eigen::Vector2cd(Complex(0, 1), Complex(0, 0))}};
  return diagram;
}

TEST(CampbellTables, HaveARowForEachPointSpeedAndPlace) {
  const CampbellTables tables = tables_of(one_mode());
  EXPECT_EQ(tables.campbell_csv,
            "speed_hz,mode,whirl,forward_share,frequency_hz,damping_ratio\n"
            "10,3,forward,1,40,0.02\n20,3,mixed,0.5,42,-0.01\n");
  EXPECT_EQ(tables.critical_speeds_csv, "mode,whirl,speed_hz,damping_ratio\n3,backward,41.5,0.02\n");
  EXPECT_EQ(tables.mode_shapes_csv,
            "mode,whirl,speed_hz,frequency_hz,position_m,x_real,x_imag,y_real,y_imag\n"
            "3,backward,41.5,41.5,0,1,0,0,1\n3,backward,41.5,41.5,0.5,0.5,0.25,0,0\n");
  EXPECT_EQ(tables.summary,
            "mode 3    40 Hz at 10 Hz (600 rpm), 42 Hz at 20 Hz (1200 rpm) (mixed), unstable at some speeds\n"
            "critical  41.5 Hz (2490 rpm), mode 3, backward, damping ratio 0.02\n");
}

TEST(CampbellTables, HaveARowForEachLockSpeed) {
  Campbell diagram;
  diagram.modes = {{.number = 1, .points = {{0, 10, 0.02, 0}, {40, 10, 0.02, 0}}},
                   {.number = 2, .points = {{0, 10, 0.02, 1}, {40, 10, 0.02, 1}}}};
  const CampbellTables tables = tables_of(diagram);
  EXPECT_EQ(tables.lock_speeds_csv, "speed_hz,p,first_mode,q,second_mode\n20,3,2,1,1\n30,2,2,1,1\n");
  EXPECT_NE(tables.summary.find(
                "lock      30 Hz (1800 rpm), 2 turns of mode 2 to 1 of mode 1 in the turning frame\n"),
            std::string::npos)
      << tables.summary;
}

TEST(CampbellTables, SayThatThereIsNoCriticalSpeed) {
  Campbell diagram = one_mode();
  diagram.critical_speeds.clear();
  EXPECT_TRUE(tables_of(diagram).summary.ends_with("critical  none in this range of speeds\n"));
}

}  // namespace
}  // namespace rubsweep::apps
