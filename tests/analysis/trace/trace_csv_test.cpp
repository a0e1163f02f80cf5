#include "rubsweep/analysis/trace/trace_csv.hpp"

#include <gtest/gtest.h>

namespace rubsweep::trace {
namespace {

TraceState state_with_two_stops() {
  TraceState state;
  state.displacement_m = {1e-3, -2.5e-4};
  state.velocity_m_per_s = {0.5, -0.125};
  state.stops.resize(2);
  state.stops[0] = {.casing_m = {1e-5, 2e-5},
                    .casing_m_per_s = {0.25, -1},
                    .gap_m = -3e-6,
                    .normal_force_n = 12.5,
                    .friction_force_n = 1.25};
  state.stops[1].gap_m = 0.1 + 0.2;
  state.energy = {1, 2, 3, 4, -5, -6, -7};
  return state;
}

TEST(TraceCsvTrajectory, HasTheRotorThenEveryStop) {
  const std::string energies =
      ",kinetic_energy_j,elastic_energy_j,contact_energy_j,forcing_power_w,damping_power_w,"
      "contact_damping_power_w,friction_power_w\n";
  EXPECT_EQ(trajectory_csv({}), "t_s,x_m,y_m,vx_m_per_s,vy_m_per_s" + energies);
  Trace trace;
  trace.stops = 2;
  trace.trajectory = {{0.0625, state_with_two_stops()}};
  // The shortest text that reads back to the same double.
  EXPECT_EQ(trajectory_csv(trace),
            "t_s,x_m,y_m,vx_m_per_s,vy_m_per_s,"
            "casing_0_x_m,casing_0_y_m,gap_0_m,normal_force_0_n,friction_force_0_n,"
            "casing_1_x_m,casing_1_y_m,gap_1_m,normal_force_1_n,friction_force_1_n,"
            "casing_0_vx_m_per_s,casing_0_vy_m_per_s,casing_1_vx_m_per_s,casing_1_vy_m_per_s" +
                energies +
                "0.0625,0.001,-0.00025,0.5,-0.125,1e-05,2e-05,-3e-06,12.5,1.25,0,0,0.30000000000000004,0,0,"
                "0.25,-1,0,0,1,2,3,4,-5,-6,-7\n");
}

TEST(TraceCsvSection, HasTheRotorThenTheCasings) {
  Trace trace;
  trace.stops = 2;
  TraceState at_rest;
  at_rest.stops.resize(2);
  trace.section = {{0, at_rest}, {1250.5, state_with_two_stops()}};
  EXPECT_EQ(
      section_csv(trace),
      "revolution,t_s,x_m,y_m,vx_m_per_s,vy_m_per_s,casing_0_x_m,casing_0_y_m,casing_1_x_m,casing_1_y_m,"
      "casing_0_vx_m_per_s,casing_0_vy_m_per_s,casing_1_vx_m_per_s,casing_1_vy_m_per_s\n"
      "0,0,0,0,0,0,0,0,0,0,0,0,0,0\n"
      "1,1250.5,0.001,-0.00025,0.5,-0.125,1e-05,2e-05,0,0,0.25,-1,0,0\n");
}

TEST(TraceCsvTrajectory, HasTheCoordinatesOfARotorKit) {
  Trace trace;
  trace.vibration_coordinates = 2;
  TraceState state;
  state.coordinates_m = Eigen::Vector2d(1, 2);
  state.rates_m_per_s = Eigen::Vector2d(3, 4);
  trace.trajectory = {{0, state}};
  EXPECT_EQ(trajectory_csv(trace),
            "t_s,x_m,y_m,vx_m_per_s,vy_m_per_s,coordinate_0_m,coordinate_0_m_per_s,coordinate_1_m,"
            "coordinate_1_m_per_s,kinetic_energy_j,elastic_energy_j,contact_energy_j,forcing_power_w,"
            "damping_power_w,contact_damping_power_w,friction_power_w\n"
            "0,0,0,0,0,1,3,2,4,0,0,0,0,0,0,0\n");
}

TEST(TraceCsvEvents, NamesTheModes) {
  using contact::Mode;
  Trace trace;
  trace.switches = {{0.25, {.phase_rad = 1, .contact = 1, .from = Mode::open, .to = Mode::clamped}},
                    {0.5, {.phase_rad = 1, .contact = 0, .from = Mode::sprung, .to = Mode::released}}};
  EXPECT_EQ(events_csv(trace), "t_s,stop,from,to\n0.25,1,open,clamped\n0.5,0,sprung,released\n");
}

TEST(TraceCsvSpectrum, ListsOrdersUpwardsWithSignedFrequencies) {
  const response::spectrum::FullSpectrum spectrum{
      .turns = 2, .samples_per_revolution = 2, .amplitude_m = {1e-6, 2e-6, 3e-6, 4e-6}};
  EXPECT_EQ(spectrum_csv(spectrum, 75),
            "order,frequency_hz,amplitude_m\n"
            "-1,-75,1e-06\n"
            "-0.5,-37.5,2e-06\n"
            "0,0,3e-06\n"
            "0.5,37.5,4e-06\n");
  EXPECT_EQ(spectrum_csv({}, 75), "order,frequency_hz,amplitude_m\n");
}

}  // namespace
}  // namespace rubsweep::trace
