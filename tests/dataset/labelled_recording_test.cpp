#include "rubsweep/dataset/labelled_recording.hpp"

#include <gtest/gtest.h>

#include "dataset/small_study.hpp"

namespace rubsweep::dataset {
namespace {

using diagnose::Unknown;

bool lies_in(double low, double value, double high) { return low <= value && value <= high; }

TEST(LabelledRecording, DependsOnStudyAndIndexAlone) {
  response::motion::Workspace used, fresh;
  make_recording(small_study(), 1, used);
  const LabelledRecording one = make_recording(small_study(), 3, used),
                          same = make_recording(small_study(), 3, fresh);
  EXPECT_EQ(one.x_m, same.x_m);
  EXPECT_EQ(one.y_m, same.y_m);
  EXPECT_EQ(one.values, same.values);
  DataStudy other = small_study();
  other.seed = 2;
  EXPECT_NE(make_recording(other, 3, fresh).x_m, one.x_m);
}

TEST(LabelledRecording, RecordingsOfAMachineShareItsNumbersAndNotTheirOwn) {
  response::motion::Workspace workspace;
  const LabelledRecording a = make_recording(small_study(), 2, workspace),
                          b = make_recording(small_study(), 3, workspace),
                          c = make_recording(small_study(), 4, workspace);
  EXPECT_EQ(a.machine, b.machine);
  EXPECT_NE(a.machine, c.machine);
  for (const Unknown unknown : {Unknown::natural_frequency, Unknown::damping_ratio, Unknown::stiffness})
    EXPECT_EQ(value_of(a.values, unknown), value_of(b.values, unknown));
  EXPECT_NE(value_of(a.values, Unknown::natural_frequency), value_of(c.values, Unknown::natural_frequency));
  EXPECT_EQ(a.clearance_m, b.clearance_m);
  EXPECT_EQ(a.stop_angle_deg, b.stop_angle_deg);
  EXPECT_EQ(a.gain, b.gain);
  EXPECT_EQ(a.part, b.part);
  EXPECT_NE(a.speed_hz, b.speed_hz);
  EXPECT_NE(value_of(a.values, Unknown::whirl_ratio), value_of(b.values, Unknown::whirl_ratio));
}

TEST(LabelledRecording, NumbersStayInTheirRanges) {
  response::motion::Workspace workspace;
  const DataStudy study = small_study();
  for (std::size_t index = 0; index < 6; ++index) {
    const LabelledRecording recording = make_recording(study, index, workspace);
    const double frequency_hz = value_of(recording.values, Unknown::natural_frequency);
    EXPECT_TRUE(lies_in(study.speed_ratio.low, recording.speed_hz / frequency_hz, study.speed_ratio.high));
    EXPECT_TRUE(lies_in(25, frequency_hz, 35));
    EXPECT_TRUE(lies_in(1e-4, recording.clearance_m, 5e-4));
    EXPECT_TRUE(recording.candidate == 1 || !recording.motion.rubs);
  }
}

}  // namespace
}  // namespace rubsweep::dataset
