#include "rubtrace/motion_summary.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace rubsweep::apps {
namespace {

using response::motion::MotionClass;

sweep::Row subharmonic_row() {
  sweep::Row row;
  row.speed_hz = 75;
  row.whirl_ratio = 0.4;
  row.eccentricity_m = 3.36e-4;
  row.motion_class = MotionClass::subharmonic;
  row.order = 2;
  row.measures.emplace();
  row.measures->orbit = response::spectrum::OrbitKind::oval;
  row.measures->whirl = response::spectrum::WhirlKind::mixed;
  row.proof = response::motion::Proof::observed;
  row.revolutions = 600;
  return row;
}

TEST(MotionSummary, NamesTheCellAndItsMotion) {
  EXPECT_EQ(motion_summary(subharmonic_row()),
            "cell      75 Hz (4500 rpm), whirl ratio 0.4, eccentricity 0.000336 m\n"
            "motion    subharmonic 1/2, oval orbit, mixed whirl, observed after 600 revolutions\n");
  sweep::Row row;
  row.speed_hz = 30;
  row.whirl_ratio = 0.5;
  row.eccentricity_m = std::numeric_limits<double>::quiet_NaN();
  row.status = "unreachable";
  EXPECT_EQ(motion_summary(row),
            "cell      30 Hz (1800 rpm), whirl ratio 0.5, eccentricity none\nmotion    failed, status "
            "unreachable\n");
  row.motion_class = MotionClass::non_contact;
  row.eccentricity_m = 1e-5;
  row.status = "ok";
  row.proof = response::motion::Proof::rest;
  row.revolutions = 14;
  EXPECT_EQ(motion_summary(row),
            "cell      30 Hz (1800 rpm), whirl ratio 0.5, eccentricity 1e-05 m\n"
            "motion    non_contact, rest proven after 14 revolutions\n");
}

}  // namespace
}  // namespace rubsweep::apps
