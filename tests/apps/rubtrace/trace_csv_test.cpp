#include "rubtrace/trace_csv.hpp"

#include <gtest/gtest.h>

namespace rubsweep::apps {
namespace {

using trace::Trace;
using trace::TraceState;
using trace::TraceWindow;

/// Spectrum over 4 turns of 4 samples, with lines from -2X to 1.75X. `amplitude`: pairs of line number and
/// amplitude.
response::spectrum::FullSpectrum spectrum_of(std::initializer_list<std::pair<int, double>> amplitude) {
  response::spectrum::FullSpectrum spectrum{
      .turns = 4, .samples_per_revolution = 4, .amplitude_m = std::vector<double>(16)};
  for (const auto& [k, value] : amplitude) spectrum.amplitude_m[static_cast<std::size_t>(8L + k)] = value;
  return spectrum;
}

TEST(TraceCsvTraceSummaryLargestLines, AreSortedPeaksWithoutTheMean) {
  const auto lines = largest_lines(
      spectrum_of({{-8, 1e-5}, {-4, 3e-4}, {0, 5e-3}, {2, 7e-4}, {3, 6.9e-4}, {7, 1e-4}}), 3, 1e-3);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0].order, 0.5);
  EXPECT_EQ(lines[0].amplitude_m, 7e-4);
  EXPECT_EQ(lines[1].order, -1);
  EXPECT_EQ(lines[2].order, 1.75);
}

TEST(TraceCsvTraceSummaryLargestLines, StopAtTheFloorOfSignificance) {
  EXPECT_EQ(largest_lines(spectrum_of({{4, 1e-3}, {-4, 0.9e-6}}), 5, 1e-6).size(),
            1u);  // 1e-3 of the largest line
  EXPECT_EQ(largest_lines(spectrum_of({{4, 1e-3}, {-4, 1.1e-6}}), 5, 1e-6).size(), 2u);
  EXPECT_EQ(largest_lines(spectrum_of({{4, 0.9e-9}}), 5, 1e-3).size(), 0u);  // below 1e-6 of the clearance
  EXPECT_EQ(largest_lines(spectrum_of({}), 5, 1e-3).size(), 0u);
  EXPECT_EQ(largest_lines({}, 5, 1e-3).size(), 0u);
}

TEST(TraceCsvTraceSummary, ShowsPeaksHitsLinesAndEffort) {
  Trace trace;
  trace.revolutions = 10;
  trace.turns.assign(
      10, {.hits = 1, .contact_fraction = 0.2, .peak_displacement_m = 2e-3, .peak_contact_force_n = 50});
  trace.turns[0].peak_displacement_m = 3.5e-3;
  trace.turns[0].peak_contact_force_n = 400;
  trace.last_contact_revolution = 9;
  trace.effort = {.rhs_calls = 7000, .steps = 1000, .refused = 25, .switches = 40};
  TraceWindow window;
  window.turns = 4;
  window.contact = facts_of_last(trace, 4);
  window.contact.hits = 2;
  window.spectrum = spectrum_of({{2, 7e-4}, {-4, 3e-4}});
  EXPECT_EQ(
      trace_summary(trace, window, 1e-3),
      "run       10 revolutions, last contact in revolution 9\n"
      "peak      3.5 clearances, 400 N; 2 clearances, 50 N in the last 4 revolutions\n"
      "contact   0.5 hits per revolution, 20 % of the time, in the last 4 revolutions\n"
      "lines     +0.5X 0.0007 m, -1X 0.0003 m\n"
      "effort    700.0 right-hand sides, 100.0 steps, 2.5 refused, 4.00 mode switches per revolution\n");
}

TEST(TraceCsvTraceSummary, SaysLengthsAsTheyAreAskedFor) {
  Trace trace;
  trace.revolutions = 4;
  trace.turns.assign(4, {.peak_displacement_m = 2e-3, .peak_contact_force_n = 50});
  TraceWindow window;
  window.turns = 4;
  window.contact = facts_of_last(trace, 4);
  window.spectrum = spectrum_of({{2, 7e-4}});
  const std::string text = trace_summary(trace, window, 1e-3, {model::LengthUnit::um, true});
  EXPECT_NE(text.find("peak      2 clearances, 2000 um, 50 N; "), std::string::npos) << text;
  EXPECT_NE(text.find("lines     +0.5X 1400 um peak to peak\n"), std::string::npos) << text;
}

TEST(TraceCsvTraceSummary, OfARunWithoutARevolutionSaysSo) {
  EXPECT_EQ(trace_summary({}, {}, 1e-3), "run       0 revolutions, no contact\n");
}

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
  // Numbers are written with the fewest digits that give the same double.
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
}  // namespace rubsweep::apps
