#include "rubbranch/curves_csv.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace rubsweep::apps {

using namespace branch;
using namespace branch::curves;

namespace {

CurvePoint point_at(double first, double second, double arclength) {
  CurvePoint point;
  point.place = {first, second, 0};
  point.arclength = arclength;
  point.multipliers = Eigen::VectorXcd::Constant(1, {0.5, 0});
  point.facts.hits = 3;
  return point;
}

std::vector<CurveFrom> one_curve() {
  Curve curve;
  curve.kind = continuation::EventKind::graze;
  curve.order = 2;
  curve.points = {point_at(60, 0.2, -1), point_at(75, 0.5, 0)};
  curve.meetings = {{MeetingKind::graze_fold, point_at(70, 0.3, -0.5), 1e-13}};
  curve.forward = continuation::Ending::closed;
  return {{curve, 1, 4}};
}

TEST(CurvesCsv, RowsOfPointsAndMeetings) {
  EXPECT_EQ(
      curves_csv(one_curve()),
      "curve,kind,branch,event,parameter,curve_parameter,error,arclength,order,multiplier_1_re,multiplier_1_"
      "im,multiplier_2_re,multiplier_2_im,floquet_modulus,amplitude_m,hits,contact_fraction,feasible\n"
      "0,graze,1,4,60,0.2,0,-1,2,0.5,0,,,0.5,0,3,0,1\n"
      "0,graze,1,4,75,0.5,0,0,2,0.5,0,,,0.5,0,3,0,1\n");
  EXPECT_EQ(meetings_csv(one_curve()),
            "curve,kind,meeting,parameter,curve_parameter,arclength_error,arclength,order,multiplier_1_re,"
            "multiplier_1_im,multiplier_2_re,multiplier_2_im,floquet_modulus,amplitude_m,hits\n"
            "0,graze,graze_fold,70,0.3,1e-13,-0.5,2,0.5,0,,,0.5,0,3\n");
}

TEST(CurvesCsv, CommentsAndSummarySayHowACurveEnds) {
  EXPECT_EQ(curve_comments("speed_hz", "whirl_ratio", one_curve()),
            "# parameter speed_hz\n# curve_parameter whirl_ratio\n"
            "# curve 0: graze, order 2, ends left_range and closed\n");
  EXPECT_EQ(
      curves_summary("speed_hz", "whirl_ratio", one_curve()),
      "curve 0   graze of order 2, speed_hz 60 to 75, whirl_ratio 0.2 to 0.5, 2 points, ends left_range and "
      "closed\n  graze_fold           70, 0.3\n");
}

}  // namespace
}  // namespace rubsweep::apps
