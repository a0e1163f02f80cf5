#include "rubtrace/ramp_tables.hpp"

#include <gtest/gtest.h>

namespace rubsweep::apps {

using namespace ramp;

namespace {

using response::motion::MotionClass;

line::LinePoint steady(double speed_hz, MotionClass motion_class, double contact_fraction) {
  line::LinePoint point;
  point.row.speed_hz = speed_hz;
  point.row.motion_class = motion_class;
  point.row.measures.emplace();
  point.row.measures->contact.contact_fraction = contact_fraction;
  point.row.measures->contact.peak_displacement_m = 2e-3;
  return point;
}

TEST(RampTables, NeighboursThatRubAreOneSpan) {
  const std::vector points{steady(50, MotionClass::synchronous, 1), steady(40, MotionClass::chaotic, 0.2),
                           steady(30, MotionClass::non_contact, 0),
                           steady(20, MotionClass::subharmonic, 0.1)};
  const auto spans = rubbing_spans(points);
  ASSERT_EQ(spans.size(), 2u);
  EXPECT_EQ(spans[0].from_hz, 50);
  EXPECT_EQ(spans[0].to_hz, 40);
  EXPECT_EQ(spans[1].from_hz, 20);
  EXPECT_EQ(spans[1].to_hz, 20);
}

TEST(RampTables, HaveARowForEachPoint) {
  const SpeedRamp ramp{10, 20, 10, 0};
  RampRecord record(ramp);
  RampStretch stretch;
  stretch.begin_s = 0.5;
  stretch.end_s = 0.5625;
  stretch.samples = {{0.5, {1e-3, -2e-3}, {0, 0}}, {0.525, {-3e-3, 4e-3}, {0, 0}}};
  stretch.touched = true;
  stretch.hits = 1;
  stretch.touching_s = 0.03125;
  stretch.peak_displacement_m = 5e-3;
  stretch.peak_contact_force_n = 7;
  record.add(stretch);
  const RampTables tables = tables_of(record, std::vector{steady(15, MotionClass::non_contact, 0)});
  EXPECT_EQ(
      tables.envelope_csv,
      "t_s,speed_hz,lowest_x_m,highest_x_m,lowest_y_m,highest_y_m,peak_displacement_m,peak_contact_force_n,"
      "hits,contact_fraction\n0.55,15.5,-0.003,0.001,-0.002,0.004,0.005,7,1,0.5\n");
  EXPECT_EQ(tables.orbits_csv,
            "orbit,speed_hz,t_s,x_m,y_m\n0,15,0.5,0.001,-0.002\n1,15.25,0.525,-0.003,0.004\n");
  EXPECT_EQ(tables.spectrogram_csv, "t_s,speed_hz,order,amplitude_m\n");
  EXPECT_EQ(tables.quasi_static_csv, "speed_hz,class,order,peak_displacement_m\n15,non_contact,,0.002\n");
  EXPECT_EQ(tables.rub_csv, "source,from_hz,to_hz\nramp,15,15.625\n");
  EXPECT_EQ(
      tables.summary,
      "peak      0.005 m at 15.5 Hz (930 rpm), largest contact force 7 N\nrubs      15 to 15.625 Hz (900 to "
      "937.5 rpm)\nsteadily  "
      "nowhere\n");
}

}  // namespace
}  // namespace rubsweep::apps
